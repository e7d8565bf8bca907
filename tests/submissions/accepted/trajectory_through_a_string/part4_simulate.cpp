#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <limits>
#include <sstream>

using namespace Eigen;

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  // collect everything as text first, as if it were a file
  std::stringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  State state{q_0, v_0};
  for (int i = 0; i < params.T; i++) {
    if (i > 0) state = step(state.q, state.v, params);
    for (int k = 0; k < 3; k++) text << state.q(k) << " ";
    for (int k = 0; k < 3; k++) text << state.v(k) << " ";
    text << "\n";
  }

  MatrixXd Q(3, params.T);
  MatrixXd V(3, params.T);
  for (int i = 0; i < params.T; i++) {
    for (int k = 0; k < 3; k++) text >> Q(k, i);
    for (int k = 0; k < 3; k++) text >> V(k, i);
  }
  Trajectory out;
  out.q = Q;
  out.v = V;
  return out;
}

}  // namespace bounce
