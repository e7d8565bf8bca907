#include "lemke.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace bounce::study {
namespace {

using Eigen::Index;

constexpr double kLeastPivot = 1e-12;

// Columns w_1 .. w_n, z_1 .. z_n, z_0, p; a row for each basic variable.
struct Tableau {
  Index n;
  Eigen::MatrixXd T;
  std::vector<Index> basic;

  Index z_0() const { return 2 * n; }
  Index p() const { return 2 * n + 1; }

  Index pivot(Index row, Index entering) {
    T.row(row) /= T(row, entering);
    for (Index i = 0; i < n; ++i)
      if (i != row) T.row(i) -= T(i, entering) * T.row(row);
    return std::exchange(basic[std::size_t(row)], entering);
  }

  // Whether row i blocks before row j: the ratios, then, in a tie, those of the columns of w.
  bool blocks_before(Index i, Index j, Index entering) const {
    const double t_i = T(i, entering), t_j = T(j, entering);
    for (Index k = -1; k < n; ++k) {
      const Index column = k < 0 ? p() : k;
      const double difference = T(i, column) / t_i - T(j, column) / t_j;
      if (std::abs(difference) > kLeastPivot) return difference < 0;
      if (basic[std::size_t(i)] == z_0() || basic[std::size_t(j)] == z_0())
        return basic[std::size_t(i)] == z_0();
    }
    return false;
  }

  Index blocking_row(Index entering) const {
    Index row = -1;
    for (Index i = 0; i < n; ++i) {
      if (T(i, entering) > kLeastPivot && (row < 0 || blocks_before(i, row, entering))) row = i;
    }
    return row;
  }

  Eigen::VectorXd solution() const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i) {
      const Index variable = basic[std::size_t(i)];
      if (variable >= n && variable < z_0()) z(variable - n) = T(i, p());
    }
    return z;
  }
};

Tableau start(const Eigen::MatrixXd& V, const Eigen::VectorXd& p) {
  const Index n = p.size();
  Tableau tableau{n, Eigen::MatrixXd(n, 2 * n + 2), std::vector<Index>(std::size_t(n))};
  tableau.T << Eigen::MatrixXd::Identity(n, n), -V, -Eigen::VectorXd::Ones(n), p;
  for (Index i = 0; i < n; ++i) tableau.basic[std::size_t(i)] = i;
  return tableau;
}

}  // namespace

LemkeResult lemke(const Eigen::MatrixXd& V, const Eigen::VectorXd& p) {
  const Index n = p.size();
  if ((p.array() >= 0).all()) return {Eigen::VectorXd::Zero(n), true, 0};
  Tableau tableau = start(V, p);
  Index row = 0;
  p.minCoeff(&row);
  Index leaving = tableau.pivot(row, tableau.z_0());
  for (int pivots = 1; pivots < 100; ++pivots) {
    if (leaving == tableau.z_0()) return {tableau.solution(), true, pivots};
    const Index entering = leaving < n ? leaving + n : leaving - n;
    row = tableau.blocking_row(entering);
    if (row < 0) return {tableau.solution(), false, pivots};
    leaving = tableau.pivot(row, entering);
  }
  return {tableau.solution(), false, 100};
}

double lcp_residual(const Eigen::MatrixXd& V, const Eigen::VectorXd& p, const Eigen::VectorXd& z) {
  const Eigen::VectorXd w = V * z + p;
  if (!w.allFinite()) return std::numeric_limits<double>::infinity();
  return z.cwiseMin(w).cwiseAbs().maxCoeff();
}

Lcp8 form_lcp8(const Arm<double>& r_1, const Arm<double>& r_2, const Vector3& v,
               const Parameters& params) {
  Eigen::Matrix<double, 3, 6> J_hat;  // J_n, -J_t and J_t of each
  J_hat << 0, -1, 1, 0, -1, 1,        //
      1, 0, 0, 1, 0, 0,               //
      r_1.x, r_1.y, -r_1.y, r_2.x, r_2.y, -r_2.y;
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Eigen::Matrix<double, 6, 6> A = J_hat.transpose() * M_inv * J_hat * params.dt;
  const Eigen::Matrix<double, 6, 1> w = J_hat.transpose() * (v + params.dt * params.g);

  Lcp8 lcp{Eigen::MatrixXd::Zero(8, 8), Eigen::VectorXd::Zero(8)};
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index j = 0; j < 2; ++j)
      lcp.V.block<3, 3>(4 * i, 4 * j) = A.block<3, 3>(3 * i, 3 * j);
    lcp.V.block<3, 1>(4 * i, 4 * i + 3) << 0, 1, 1;
    lcp.V.block<1, 3>(4 * i + 3, 4 * i) << params.mu, -1, -1;
    lcp.p.segment<3>(4 * i) = w.segment<3>(3 * i);
    const double v_n = J_hat.col(3 * i).dot(v);
    lcp.p(4 * i) += params.epsilon * std::min(v_n, 0.0);
  }
  return lcp;
}

}  // namespace bounce::study
