#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  // TODO: form V (eqs. 7 and 9) and p (eqs. 2 and 10).
  static_cast<void>(J);
  static_cast<void>(v);
  static_cast<void>(params);
  return {Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};
}

}  // namespace bounce
