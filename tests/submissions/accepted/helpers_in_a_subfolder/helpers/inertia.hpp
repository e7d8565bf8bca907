#ifndef HELPERS_INERTIA_HPP
#define HELPERS_INERTIA_HPP

#include <bounce/types.hpp>

namespace helpers {

Eigen::Matrix3d inverse_inertia(const bounce::Parameters& params);
bounce::Vector3 external_force(const bounce::Parameters& params);

}  // namespace helpers

#endif
