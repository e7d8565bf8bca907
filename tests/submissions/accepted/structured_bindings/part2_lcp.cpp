#include <bounce/part2_lcp.hpp>

namespace bounce {

auto form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) -> Lcp {
  const auto& [l, m, mu, epsilon, g, dt, delta, T] = params;
  const auto j_t = Vector3{J.col(0)};
  const auto j_n = Vector3{J.col(1)};
  const auto m_inv = Vector3{1 / m, 1 / m, 6 / (m * l * l)};

  auto j_hat = Eigen::Matrix3d{};
  j_hat << j_n, -j_t, j_t;

  auto lcp = Lcp{};
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = dt * j_hat.transpose() * m_inv.asDiagonal() * j_hat;
  lcp.V.col(3).segment<2>(1).setOnes();
  lcp.V.row(3) << mu, -1.0, -1.0, 0.0;

  const auto u = Vector3{v + dt * g};
  lcp.p << j_n.dot(u) + epsilon * j_n.dot(v), -j_t.dot(u), j_t.dot(u), 0.0;
  return lcp;
}

}  // namespace bounce
