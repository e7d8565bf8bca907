#include "../../solution/src/part2_lcp.cpp"
#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian&, const Vector3&, const Parameters&) {
  return {Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};
}

}  // namespace bounce
