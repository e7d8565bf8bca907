#include <bounce/part2_lcp.hpp>
#include <array>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 weight = params.M().diagonal().cwiseInverse();
  const std::array<Vector3, 3> dirs{Vector3(J.col(1)), Vector3(-J.col(0)), Vector3(J.col(0))};

  const auto mobility = [&weight](const Vector3& a, const Vector3& b) {
    return a.dot(weight.cwiseProduct(b));
  };
  const auto after_gravity = [&params](const Vector3& d, const Vector3& u) {
    return d.dot(u) + params.dt * d.dot(params.g);
  };
  const auto entry = [&](int i, int j) -> double {
    if (i < 3 && j < 3) return params.dt * mobility(dirs[i], dirs[j]);
    if (i < 3) return i == 0 ? 0.0 : 1.0;
    if (j < 3) return j == 0 ? params.mu : -1.0;
    return 0.0;
  };

  const Eigen::Matrix4d V = Eigen::Matrix4d::NullaryExpr(
      [&](Eigen::Index i, Eigen::Index j) { return entry(int(i), int(j)); });
  const Eigen::Vector4d p(after_gravity(dirs[0], (1 + params.epsilon) * v),
                          after_gravity(dirs[1], v),
                          after_gravity(dirs[2], v),
                          0.0);
  return {V, p};
}

}  // namespace bounce
