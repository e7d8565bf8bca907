// Lemke's method for any LCP of a moderate size (Lemke 1965, "Bimatrix equilibrium points and
// mathematical programming", Management Science 11), as one would write it from a textbook (Cottle,
// Pang & Stone 1992, "The linear complementarity problem", sections 4.4 and 4.9): the dense
// tableau, the covering vector of ones, ties broken lexicographically, and pivots no smaller than a
// tolerance. For contacts with friction in this form it ends in a solution, but for rounding
// (Stewart & Trinkle 1996; Anitescu & Potra 1997, Nonlinear Dynamics 14). It is here for
// comparison, and to show where it fails. student/given/solve_lcp.cpp derives the method and first
// scales the problem, which this one does not.
#pragma once

#include <Eigen/Dense>

#include "square.hpp"

namespace bounce::study {

struct LemkeResult {
  Eigen::VectorXd z;
  bool is_solved;  // else it ended in a ray, or after 100 pivots
  int pivots;
};

// Solves 0 <= V z + p perpendicular to z >= 0. Pivots below 1e-12, an absolute tolerance, count as
// 0. z is a solution only if `is_solved`.
LemkeResult lemke(const Eigen::MatrixXd& V, const Eigen::VectorXd& p);

// max_i |min(z_i, w_i)| with w = V z + p: how far z is from a solution, whatever a solver says.
// It compares numbers of different units, if z and p have any. NaN counts as infinite.
double lcp_residual(const Eigen::MatrixXd& V, const Eigen::VectorXd& p, const Eigen::VectorXd& z);

// The LCP of eqs. (9) and (10) for two corners with these arms, literally: z = (f_n, f_t1, f_t2,
// lambda) of the first corner, then of the second, 8x8, in forces.
struct Lcp8 {
  Eigen::MatrixXd V;
  Eigen::VectorXd p;
};
Lcp8 form_lcp8(const Arm<double>& r_1, const Arm<double>& r_2, const Vector3& v,
               const Parameters& params);

}  // namespace bounce::study
