#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

auto step(const Vector3& q, const Vector3& v, const Parameters& params) -> State {
  const auto [J, phi] = get_contacts(q, params);
  const auto in_contact = phi < params.delta;

  auto acceleration = Vector3{params.g};
  if (in_contact) {
    const auto [V, p] = form_lcp(J, v, params);
    const auto f = solve_lcp(V, p);
    const auto w = Vector3{params.M().diagonal().cwiseInverse()};
    acceleration += w.cwiseProduct(J.col(1) * f.x() + J.col(0) * (f.z() - f.y()));
  }

  auto next = State{};
  next.v = v + params.dt * acceleration;
  next.q = q + params.dt * next.v;
  if (in_contact) next.q.y() += params.delta;
  return next;
}

}  // namespace bounce
