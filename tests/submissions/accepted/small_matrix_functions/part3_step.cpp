#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Eigen::Matrix3d Minv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;

  if (!(contact.phi < params.delta)) {
    const Vector3 v1 = v + params.dt * Minv * f_e;
    return {q + params.dt * v1, v1};
  }

  Eigen::Matrix<double, 2, 3> D;
  D << 0, -1, 1,
       1, 0, 0;
  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  const Vector3 f_c = contact.J * D * f;
  const Vector3 v1 = v + params.dt * Minv * (f_e + f_c);
  const Vector3 q1 = q + params.dt * v1 + Vector3(0, params.delta, 0);
  return {q1, v1};
}

}  // namespace bounce
