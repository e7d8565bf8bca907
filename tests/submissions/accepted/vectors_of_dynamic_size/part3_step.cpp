#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

using namespace Eigen;

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Contact contact = get_contacts(q, params);
  MatrixXd Minv = params.M().inverse();
  VectorXd fe = params.M() * params.g;
  VectorXd qn, vn;

  if (contact.phi < params.delta) {
    Lcp lcp = form_lcp(contact.J, v, params);
    VectorXd f = solve_lcp(lcp.V, lcp.p);
    VectorXd Jt = contact.J.col(0);
    VectorXd Jn = contact.J.col(1);
    VectorXd total = fe + Jn * f(0) - Jt * f(1) + Jt * f(2);
    vn = v + params.dt * Minv * total;
    VectorXd correction(3);
    correction << 0, params.delta, 0;
    qn = q + params.dt * vn + correction;
  } else {
    vn = v + params.dt * Minv * fe;
    qn = q + params.dt * vn;
  }

  State state;
  state.q = qn;
  state.v = vn;
  return state;
}

}  // namespace bounce
