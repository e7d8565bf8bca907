// an old copy, for trying things out
#include <bounce/solve_lcp.hpp>

namespace bounce {

Vector3 solve_lcp(const Eigen::Matrix4d&, const Eigen::Vector4d&) { return Vector3::Zero(); }

}  // namespace bounce
