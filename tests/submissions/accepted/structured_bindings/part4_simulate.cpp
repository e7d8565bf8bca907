#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <algorithm>
#include <iterator>
#include <vector>

namespace bounce {

auto simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) -> Trajectory {
  auto states = std::vector<State>{{q_0, v_0}};
  std::generate_n(std::back_inserter(states), params.T - 1, [&, now = states.front()]() mutable {
    now = step(now.q, now.v, params);
    return now;
  });

  auto result = Trajectory{};
  result.q.resize(3, std::ssize(states));
  result.v.resize(3, std::ssize(states));
  auto t = Eigen::Index{0};
  for (const auto& [q, v] : states) {
    result.q.col(t) = q;
    result.v.col(t) = v;
    ++t;
  }
  return result;
}

}  // namespace bounce
