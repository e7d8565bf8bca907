// Given: the animation of a trajectory. You do not need to change it.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>

namespace bounce {

// Writes one self-contained HTML page that shows the square moving, in an endless loop.
//
//   q       3xT configurations, one column per time step: m, m, rad.
//   params  the side l, m, and the time step dt, s, that q was made with.
//   page    the file to write; open it in any browser, no network is needed.
//   throws  std::invalid_argument when q has no column or holds NaN or infinity;
//           std::runtime_error when the page cannot be written (nothing is left half-written).
void render(const Eigen::Matrix3Xd& q, const Parameters& params, const std::filesystem::path& page);

// The same with the forces of the ground, the energies, and the true motion dashed beside it, which
// need v, 3xT: m/s, m/s, rad/s, and m, mu, epsilon and g of params.
//
//   throws  as above, and std::invalid_argument when q and v have different numbers of columns.
void render(const Trajectory& trajectory, const Parameters& params,
            const std::filesystem::path& page);

}  // namespace bounce
