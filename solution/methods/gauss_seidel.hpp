// Projected Gauss-Seidel for contacts with friction (Jean 1999; Moreau's own solver): for one row
// after the other, it takes the impulse that solves this row alone, projected to its bounds,
//
//     p_n <- max(0, p_n - w / a),    p_t <- p_t - v_t / c  within +-mu p_n.
//
// Without friction and for a symmetric positive definite G it converges: each sweep multiplies the
// error by the square of the spectral radius of Jacobi's iteration matrix. For a square of mass R
// that rests on one of mass 1 that is R / (1 + R), so the number of sweeps grows with R. With
// friction nothing is promised: at mu 2 a single corner can keep it from converging.
#pragma once

#include <Eigen/Dense>

namespace bounce::study {

struct GaussSeidel {
  Eigen::VectorXd p;  // the last iterate
  int sweeps;
  bool converged;
};

// w = G p + u for n contacts: G is 2n x 2n, u has 2n entries, m/s, and p the impulses (p_n, p_t) of
// one contact after the other, divided by the mass. Ends when a sweep changes no row by more than
// `tolerance`, m/s, or after `most_sweeps`.
GaussSeidel gauss_seidel(const Eigen::MatrixXd& G, const Eigen::VectorXd& u, double mu,
                         double tolerance, int most_sweeps);

}  // namespace bounce::study
