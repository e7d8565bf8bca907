#include "inertia.hpp"

namespace helpers {

Eigen::Matrix3d inverse_inertia(const bounce::Parameters& params) {
  const double r_g_squared = params.l * params.l / 6;
  return bounce::Vector3(1, 1, 1 / r_g_squared).asDiagonal() * (1 / params.m);
}

bounce::Vector3 external_force(const bounce::Parameters& params) { return params.M() * params.g; }

}  // namespace helpers
