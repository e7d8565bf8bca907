#include "rotation.hpp"

#include <cmath>

namespace helpers {

Eigen::Matrix2d rotation(double theta) {
  Eigen::Matrix2d R;
  R << std::cos(theta), -std::sin(theta),
       std::sin(theta),  std::cos(theta);
  return R;
}

}  // namespace helpers
