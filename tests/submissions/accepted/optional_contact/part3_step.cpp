#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <optional>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const auto find = [&]() -> std::optional<Jacobian> {
    const Contact contact = get_contacts(q, params);
    if (contact.phi < params.delta) return contact.J;
    return std::nullopt;
  };
  const auto push = [&](const Jacobian& J) -> Vector3 {
    const Lcp lcp = form_lcp(J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    return J.col(1) * f(0) + J.col(0) * (f(2) - f(1));
  };

  const std::optional<Jacobian> J = find();
  const Vector3 f = J ? push(*J) : Vector3(0, 0, 0);
  State next{q, v};
  next.v += params.dt * params.g;
  next.v += params.dt * params.M().inverse() * f;
  next.q += params.dt * next.v;
  next.q(1) += J.has_value() * params.delta;
  return next;
}

}  // namespace bounce
