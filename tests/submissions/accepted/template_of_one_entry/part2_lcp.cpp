#include <bounce/part2_lcp.hpp>
#include <utility>

namespace bounce {
namespace {

constexpr int kColumn[] = {1, 0, 0};    // of J: normal, tangential, tangential
constexpr double kSign[] = {1, -1, 1};  // of the direction

template <int i, int k>
double entry(const Jacobian& J, const Parameters& params) {
  if constexpr (i == 3) return k == 0 ? params.mu : k == 3 ? 0 : -1;
  else if constexpr (k == 3) return i == 0 ? 0 : 1;
  else {
    const double a = J(0, kColumn[i]) * J(0, kColumn[k]) + J(1, kColumn[i]) * J(1, kColumn[k]);
    const double b = J(2, kColumn[i]) * J(2, kColumn[k]);
    return kSign[i] * kSign[k] * params.dt * (a + 6 * b / (params.l * params.l)) / params.m;
  }
}

template <std::size_t... n>
Eigen::Matrix4d matrix(const Jacobian& J, const Parameters& params, std::index_sequence<n...>) {
  Eigen::Matrix4d V;
  ((V(n / 4, n % 4) = entry<n / 4, n % 4>(J, params)), ...);
  return V;
}

}  // namespace

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Vector2d now = J.transpose() * v, pushed = params.dt * J.transpose() * params.g;
  const double slip = now(0) + pushed(0);
  return {matrix(J, params, std::make_index_sequence<16>()),
          {(1 + params.epsilon) * now(1) + pushed(1), -slip, slip, 0}};
}

}  // namespace bounce
