#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

// Where the square stands along the ground makes no difference: the step is taken at x = 0, and the
// changes of q and v are added at the end.
State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  struct Change {
    Vector3 q, v;
  };
  const auto change = [&]() -> Change {
    const Contact contact = get_contacts(Vector3(0, q(1), q(2)), params);
    Vector3 dv = params.g;
    double up = 0;
    if (contact.phi < params.delta) {
      const Lcp lcp = form_lcp(contact.J, v, params);
      const auto f = solve_lcp(lcp.V, lcp.p);
      dv += params.M().inverse() * contact.J * (Eigen::Vector2d() << f[2] - f[1], f[0]).finished();
      up = params.delta;
    }
    dv *= params.dt;
    return {params.dt * v + params.dt * dv + Vector3(0, up, 0), dv};
  }();
  return {q + change.q, v + change.v};
}

}  // namespace bounce
