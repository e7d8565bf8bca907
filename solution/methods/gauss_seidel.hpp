// Projected Gauss-Seidel for contacts with friction (Jean 1999; Moreau's own solver): for one row
// after the other, it takes the impulse that solves this row alone, projected to its bounds,
//
//     p_n <- max(0, p_n - w / a),    p_t <- p_t - v_t / c  within +-mu p_n.
//
// Without friction and for a symmetric positive definite G it converges, with the square of what
// Jacobi's matrix has as spectral radius: for a square of mass 1 under one of mass R, face on face,
// by R / (1 + R) a sweep, so that sweeps grow with R. With friction nothing is promised: at mu 2
// one corner is enough to keep it from converging. The literal 4x4 of eq. (9) has a row without a
// diagonal, V_44 = 0, for which the step is undefined.
#pragma once

#include <Eigen/Dense>
#include <optional>

namespace bounce::methods {

struct GaussSeidel {
  Eigen::VectorXd p;
  int sweeps;
  bool converged;
  double residual;  // the largest change of the last sweep times the diagonal, m/s
};

// w = G p + u with (p_n, p_t) of one contact after the other, per unit of mass. Ends when a sweep
// changes nothing by more than `tolerance`, m/s.
GaussSeidel gauss_seidel(const Eigen::MatrixXd& G, const Eigen::VectorXd& u, double mu,
                         double tolerance, int most_sweeps);

// On any LCP, row by row: z_i <- max(0, z_i - w_i / V_ii). Empty if a V_ii is 0.
std::optional<GaussSeidel> gauss_seidel_lcp(const Eigen::MatrixXd& V, const Eigen::VectorXd& p,
                                            double tolerance, int most_sweeps);

}  // namespace bounce::methods
