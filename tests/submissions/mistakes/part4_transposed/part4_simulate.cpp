#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <vector>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const int T = params.T;
  std::vector<double> qs(3 * T), vs(3 * T);

  State s{q_0, v_0};
  for (int t = 0; t < T; ++t) {
    if (t > 0) s = step(s.q, s.v, params);
    for (int i = 0; i < 3; ++i) {
      qs[i * T + t] = s.q(i);
      vs[i * T + t] = s.v(i);
    }
  }

  Trajectory result;
  result.q = Eigen::Map<Eigen::Matrix3Xd>(qs.data(), 3, T);
  result.v = Eigen::Map<Eigen::Matrix3Xd>(vs.data(), 3, T);
  return result;
}

}  // namespace bounce
