#include "gauss_seidel.hpp"

#include <algorithm>
#include <cmath>

namespace bounce::methods {
namespace {

using Eigen::Index;

// Repeats sweeps until the largest change, which sweep(p) returns as a velocity, is small.
template <class Sweep>
GaussSeidel repeat(Index size, double tolerance, int most_sweeps, const Sweep& sweep) {
  GaussSeidel result{Eigen::VectorXd::Zero(size), 0, false, 0};
  while (!result.converged && result.sweeps < most_sweeps) {
    ++result.sweeps;
    result.residual = sweep(result.p);
    result.converged = result.residual <= tolerance;
  }
  return result;
}

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
  return repeat(u.size(), tolerance, most_sweeps, [&](Eigen::VectorXd& p) {
    double change = 0;
    for (Index i = 0; i < u.size(); i += 2) {
      change = std::max(change, relax(G, u, i, 0, most, p));
      change = std::max(change, relax(G, u, i + 1, -mu * p(i), mu * p(i), p));
    }
    return change;
  });
}

}  // namespace bounce::methods
