#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory result{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  for (int i = 0; i < params.T; ++i) {
    const double time = i * params.dt;
    result.q.col(i) = q_0 + v_0 * time + 0.5 * params.g * time * time;
    result.v.col(i) = v_0 + params.g * time;
  }
  return result;
}

}  // namespace bounce
