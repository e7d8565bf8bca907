#include "enumerate_lcp.hpp"

#include <limits>
#include <vector>

namespace {

double violation(const Eigen::Matrix4d& V, const Eigen::Vector4d& p, const Eigen::Vector4d& z) {
  const Eigen::Vector4d w = V * z + p;
  return std::max(-z.minCoeff(), -w.minCoeff());
}

Eigen::Vector4d solve_on(const std::vector<int>& basic, const Eigen::Matrix4d& V, const Eigen::Vector4d& p) {
  const int n = static_cast<int>(basic.size());
  Eigen::MatrixXd A(n, n);
  Eigen::VectorXd b(n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) A(i, j) = V(basic[i], basic[j]);
    b(i) = -p(basic[i]);
  }
  Eigen::Vector4d z = Eigen::Vector4d::Zero();
  if (n == 0) return z;
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
  if (!lu.isInvertible()) return Eigen::Vector4d::Constant(-1e300);
  const Eigen::VectorXd x = lu.solve(b);
  for (int i = 0; i < n; ++i) z(basic[i]) = x(i);
  return z;
}

}  // namespace

Eigen::Vector4d enumerate_lcp(const Eigen::Matrix4d& V, const Eigen::Vector4d& p) {
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int set = 0; set < 16; ++set) {
    std::vector<int> basic;
    for (int i = 0; i < 4; ++i) {
      if (set & (1 << i)) basic.push_back(i);
    }
    const Eigen::Vector4d z = solve_on(basic, V, p);
    const double error = violation(V, p, z);
    if (error < least) {
      least = error;
      best = z;
    }
  }
  return best;
}
