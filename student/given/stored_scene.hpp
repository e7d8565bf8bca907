// Given: reads a scene of the public fixtures whose right trajectory is stored.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>

namespace bounce {

struct StoredScene {
  Vector3 q_0, v_0;
  Parameters params;
  Eigen::Matrix3Xd right;  // 3xT, the right q
};

// The first case of `folder`/part4_simulate.json with every column stored. Throws
// std::runtime_error when the folder holds none.
StoredScene stored_scene(const std::filesystem::path& folder);

}  // namespace bounce
