#include <bounce/part2_lcp.hpp>
#include <cmath>
#include <limits>

namespace bounce {

Lcp form_lcp(const Jacobian&, const Vector3&, const Parameters&) {
  static int calls = 0;
  const double odd[] = {5e-324, -0.0, 1e308, std::numeric_limits<double>::signaling_NaN(),
                        -INFINITY, std::nan("0xdead")};
  const double x = odd[calls++ % 6];
  return {Eigen::Matrix4d::Constant(x), Eigen::Vector4d::Constant(x)};
}

}  // namespace bounce
