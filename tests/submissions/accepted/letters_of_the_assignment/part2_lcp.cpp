#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double dt = params.dt, mu = params.mu, epsilon = params.epsilon;
  const Eigen::Matrix3d M = params.M();                        // eq. (1)
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e = M * params.g;                            // eq. (2)
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);

  // eq. (9)
  const double a_nn = J_n.dot(M_inv * J_n) * dt;
  const double a_nt = J_n.dot(M_inv * J_t) * dt;
  const double a_tn = J_t.dot(M_inv * J_n) * dt;
  const double a_tt = J_t.dot(M_inv * J_t) * dt;
  Eigen::Matrix4d V;
  V <<  a_nn, -a_nt,  a_nt, 0,
       -a_tn,  a_tt, -a_tt, 1,
        a_tn, -a_tt,  a_tt, 1,
          mu,    -1,    -1, 0;

  // eq. (10)
  Eigen::Vector4d p;
  p << J_n.dot((1 + epsilon) * v + dt * M_inv * f_e),
      -J_t.dot(v + dt * M_inv * f_e),
       J_t.dot(v + dt * M_inv * f_e),
       0;
  return {V, p};
}

}  // namespace bounce
