#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace bounce {

namespace {

void save(const Trajectory& tr) {
  std::error_code error;
  std::filesystem::create_directories("results", error);
  if (error) return;
  std::ofstream file("results/trajectory.csv");
  if (!file) return;
  file << "x,y,theta,vx,vy,omega\n";
  for (Eigen::Index t = 0; t < tr.q.cols(); ++t) {
    file << tr.q(0, t) << ',' << tr.q(1, t) << ',' << tr.q(2, t) << ','
         << tr.v(0, t) << ',' << tr.v(1, t) << ',' << tr.v(2, t) << '\n';
  }
}

}  // namespace

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory out{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  out.q.col(0) = q_0;
  out.v.col(0) = v_0;
  for (int t = 0; t < params.T - 1; ++t) {
    const State next = step(out.q.col(t), out.v.col(t), params);
    out.q.col(t + 1) = next.q;
    out.v.col(t + 1) = next.v;
  }
  save(out);
  return out;
}

}  // namespace bounce
