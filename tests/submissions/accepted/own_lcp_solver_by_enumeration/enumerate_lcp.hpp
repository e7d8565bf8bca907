#pragma once

#include <Eigen/Dense>

// A z >= 0 with w = V z + p >= 0 and z^T w = 0, found by trying all 16 sets of entries of z that
// may differ from 0. Where several sets do, the one with the smallest error is taken.
Eigen::Vector4d enumerate_lcp(const Eigen::Matrix4d& V, const Eigen::Vector4d& p);
