#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

struct Forces {
  double f_n, f_t1, f_t2;
};

Forces* forces = nullptr;

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 v_free = v + params.dt * params.g;
  if (contact.phi >= params.delta) return {q + params.dt * v_free, v_free};

  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  forces->f_n = f(0);
  forces->f_t1 = f(1);
  forces->f_t2 = f(2);
  const Vector3 f_c = contact.J.col(1) * forces->f_n + contact.J.col(0) * (forces->f_t2 - forces->f_t1);
  const Vector3 v_next = v_free + params.dt * params.M().inverse() * f_c;
  return {q + params.dt * v_next + Vector3(0, params.delta, 0), v_next};
}

}  // namespace bounce
