#include <bounce/part2_lcp.hpp>
#include <future>

namespace bounce {

namespace {

Eigen::Matrix3d directions(const Jacobian& J) {
  Eigen::Matrix3d Jhat;
  Jhat << J.col(1), -J.col(0), J.col(0);
  return Jhat;
}

Eigen::Matrix4d matrix(const Jacobian& J, const Parameters& params) {
  const Eigen::Matrix3d Jhat = directions(J);
  const Eigen::Matrix3d Minv = params.M().inverse();
  Eigen::Matrix4d V;
  V << params.dt * Jhat.transpose() * Minv * Jhat, Vector3(0, 1, 1),
       params.mu, -1.0, -1.0, 0.0;
  return V;
}

Eigen::Vector4d vector(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 u = v + params.dt * params.g;
  Eigen::Vector4d p;
  p << directions(J).transpose() * u, 0.0;
  p(0) += params.epsilon * J.col(1).dot(v);
  return p;
}

}  // namespace

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  // V and p don't depend on each other
  std::future<Eigen::Matrix4d> V = std::async(std::launch::async, [&] { return matrix(J, params); });
  const Eigen::Vector4d p = vector(J, v, params);
  return {V.get(), p};
}

}  // namespace bounce
