#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <stdexcept>

namespace bounce {

struct Early {
  Early() { throw std::runtime_error("\x1b[31mred\x1b[0m & <b>bold</b>"); }
} early;

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact c = get_contacts(q, params);
  Vector3 v_next = v + params.dt * params.g, lift(0, 0, 0);
  if (c.phi < params.delta) {
    const Lcp lcp = form_lcp(c.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    v_next += params.dt * params.M().inverse() * c.J * Eigen::Vector2d(f(2) - f(1), f(0));
    lift(1) = params.delta;
  }
  return {q + params.dt * v_next + lift, v_next};
}

}  // namespace bounce
