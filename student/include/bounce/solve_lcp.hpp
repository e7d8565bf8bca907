// Given: the solver for the LCP of part 2. You do not need to change it.
#pragma once

#include <bounce/types.hpp>

namespace bounce {

// The contact forces (f_n, f_t1, f_t2), N, from a z >= 0 with V z + p >= 0 and z^T (V z + p) = 0.
//
//   V, p    as form_lcp returns them, 4x4 and 4.
//   throws  std::invalid_argument when V or p holds NaN or infinity;
//           std::runtime_error, with the residual it was left with, when it finds no solution
//           to 1e-12 of the problem's scale. It never returns a wrong answer silently.
//
// While the corner sticks, f_t1 and f_t2 are not unique; only their difference is meaningful.
Vector3 solve_lcp(const Eigen::Matrix4d& V, const Eigen::Vector4d& p);

}  // namespace bounce
