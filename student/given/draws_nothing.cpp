// For the programs of ./check: where a part calls `render`, nothing is drawn, as in the course's.
#include <bounce/render.hpp>

namespace bounce {

void render(const Eigen::Matrix3Xd&, const Parameters&, const std::filesystem::path&) {}
void render(const Trajectory&, const Parameters&, const std::filesystem::path&) {}

}  // namespace bounce
