#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Eigen::MatrixXd M = params.M();
  Eigen::VectorXd force = M * params.g;
  Eigen::VectorXd correction = Eigen::VectorXd::Zero(3);

  Contact contact = get_contacts(q, params);
  if (contact.phi < params.delta) {
    Lcp lcp = form_lcp(contact.J, v, params);
    Eigen::MatrixXd J_hat(3, 3);
    J_hat << contact.J.col(1), -contact.J.col(0), contact.J.col(0);
    force += J_hat * solve_lcp(lcp.V, lcp.p);
    correction(1) = params.delta;
  }

  Eigen::VectorXd v_next = v + params.dt * M.lu().solve(force);
  Eigen::VectorXd q_next = q + params.dt * v_next + correction;
  return {q_next, v_next};
}

}  // namespace bounce
