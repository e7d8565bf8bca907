#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> rows(params.T, 6);  // one state a row
  rows.row(0) << q_0.transpose(), v_0.transpose();
  for (int t = 1; t < params.T; ++t) {
    const Vector3 q = rows.row(t - 1).head<3>(), v = rows.row(t - 1).tail<3>();
    const auto q_row = step(q, v, params).q.transpose();
    const auto v_row = step(q, v, params).v.transpose();
    rows.row(t).head<3>() = q_row;
    rows.row(t).tail<3>() = v_row;
  }
  return {rows.leftCols<3>().transpose(), rows.rightCols<3>().transpose()};
}

}  // namespace bounce
