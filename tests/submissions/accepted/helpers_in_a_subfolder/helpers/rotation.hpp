#ifndef HELPERS_ROTATION_HPP
#define HELPERS_ROTATION_HPP

#include <Eigen/Dense>

namespace helpers {

Eigen::Matrix2d rotation(double theta);

}  // namespace helpers

#endif
