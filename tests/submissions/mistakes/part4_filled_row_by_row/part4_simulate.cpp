#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <vector>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<double> qs, vs;
  State s{q_0, v_0};
  for (int t = 0; t < params.T; ++t) {
    if (t > 0) s = step(s.q, s.v, params);
    qs.insert(qs.end(), s.q.data(), s.q.data() + 3);
    vs.insert(vs.end(), s.v.data(), s.v.data() + 3);
  }
  return {Eigen::Map<Rows>(qs.data(), 3, params.T), Eigen::Map<Rows>(vs.data(), 3, params.T)};
}

}  // namespace bounce
