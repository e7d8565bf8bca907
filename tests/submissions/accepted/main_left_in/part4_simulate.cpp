#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <iostream>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  State s{q_0, v_0};
  trajectory.q.col(0) = s.q;
  trajectory.v.col(0) = s.v;
  for (int t = 1; t < params.T; ++t) {
    s = step(s.q, s.v, params);
    trajectory.q.col(t) = s.q;
    trajectory.v.col(t) = s.v;
  }
  return trajectory;
}

}  // namespace bounce

int main(int argc, char** argv) {
  bounce::Parameters params;
  if (argc > 1) params.T = std::stoi(argv[1]);
  std::cout << bounce::simulate({0, 1.5, 0.5236}, {0, -0.2, 0}, params).q.transpose() << std::endl;
}
