#include <bounce/part2_lcp.hpp>

namespace bounce {
namespace {

constexpr auto inverse_of = [](double x) { return 1 / x; };

template <int N>
using Square = Eigen::Matrix<double, N, N>;

template <typename A, typename B>
double metric(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b, const Vector3& weights) {
  return (a.array() * weights.array() * b.array()).sum();
}

}  // namespace

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 W = params.M().diagonal().unaryExpr(inverse_of);
  const std::array<Vector3, 3> hat = {J.col(1), -J.col(0), J.col(0)};

  Lcp lcp{Square<4>::Zero(), Eigen::Vector4d::Zero()};
  for (int i = 0; const Vector3& a : hat) {
    for (int j = 0; const Vector3& b : hat) lcp.V(i, j++) = params.dt * metric(a, b, W);
    lcp.p(i) = a.dot(v + params.dt * params.g) + (i == 0 ? params.epsilon * a.dot(v) : 0.0);
    lcp.V(i, 3) = i > 0;
    lcp.V(3, i) = i > 0 ? -1.0 : params.mu;
    ++i;
  }
  return lcp;
}

}  // namespace bounce
