#include "gauss_seidel.hpp"

#include <algorithm>
#include <cmath>

namespace bounce::study {
namespace {

using Eigen::Index;

// Solves row i alone, within [low, high]; returns the change as a velocity.
double relax(const Eigen::MatrixXd& G, const Eigen::VectorXd& u, Index i, double low, double high,
             Eigen::VectorXd& p) {
  const double before = p(i);
  p(i) = std::clamp(before - (G.row(i).dot(p) + u(i)) / G(i, i), low, high);
  return std::abs(p(i) - before) * G(i, i);
}

}  // namespace

GaussSeidel gauss_seidel(const Eigen::MatrixXd& G, const Eigen::VectorXd& u, double mu,
                         double tolerance, int most_sweeps) {
  const double most = std::numeric_limits<double>::max();
  GaussSeidel result{Eigen::VectorXd::Zero(u.size()), 0, false};
  Eigen::VectorXd& p = result.p;
  for (; !result.converged && result.sweeps < most_sweeps; ++result.sweeps) {
    double change = 0;
    for (Index i = 0; i < u.size(); i += 2) {
      change = std::max(change, relax(G, u, i, 0, most, p));
      change = std::max(change, relax(G, u, i + 1, -mu * p(i), mu * p(i), p));
    }
    result.converged = change <= tolerance;
  }
  return result;
}

}  // namespace bounce::study
