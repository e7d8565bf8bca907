#include <stdexcept>
#include <vector>

#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  std::vector<double> heights(params.T);
  Trajectory path{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  State now{q_0, v_0};
  double* height = heights.data();
  for (int t = 0; t < params.T; ++t) {
    if (t > 0) now = step(now.q, now.v, params);
    path.q.col(t) = now.q;
    path.v.col(t) = now.v;
    height[t] = now.q(1);
  }
  int rising = 0;
  for (int t = 0; t < params.T; ++t) rising += height[t + 1] > height[t];
  if (rising > params.T) throw std::logic_error("it rises more often than it moves");
  return path;
}

}  // namespace bounce
