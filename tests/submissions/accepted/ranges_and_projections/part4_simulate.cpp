#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <ranges>

namespace bounce {

auto simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) -> Trajectory {
  auto tr = Trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  auto now = State{q_0, v_0};
  for (auto t : std::views::iota(0, params.T)) {
    if (t > 0) now = step(now.q, now.v, params);
    tr.q.col(t) = now.q;
    tr.v.col(t) = now.v;
  }
  return tr;
}

}  // namespace bounce
