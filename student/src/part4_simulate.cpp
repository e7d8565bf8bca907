#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  // TODO: fill in the columns, each one step from the column before (eq. 15).
  static_cast<void>(q_0);
  static_cast<void>(v_0);
  static_cast<void>(params);
  return {Eigen::Matrix3Xd::Zero(3, 0), Eigen::Matrix3Xd::Zero(3, 0)};
}

}  // namespace bounce
