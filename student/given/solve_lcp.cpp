// Given: Lemke's method for the LCP of part 2. You do not need to change it.
//
// The problem. With w = V z + p, find z >= 0 and w >= 0 such that every z_i w_i = 0, eq. (8).
//
// Scaling. V mixes forces and velocities, so solve for z' = z / (d s) and w' = d w / s instead,
// with V' = D V D, D = diag(d) and p' = d p / s. With d > 0 signs stay, and complementarity with
// them. A row with a diagonal has d_i = 1 / sqrt(v), v the largest |V_ij| or |V_ji| over such rows
// j: the forces get a diagonal of about 1. The cone's row has none: its d makes the largest entry
// that it shares with the others 1. All of V' is bounded then. s is the size of d p. All are powers
// of two, so scaling does not round.
//
// Lemke's method. Write w' - V' z' - e z_0 = p' with one more variable, z_0 >= 0, and the covering
// vector e = (1, 1, 1, 1). Raise z_0 until w' >= 0: one w_i leaves the basis. Whatever leaves, its
// complement enters next (z_i for w_i, w_i for z_i), until z_0 leaves and the LCP is solved, or
// until nothing blocks the entering variable: the path ends on a ray.
//
// Lexicographic rule. The columns of f_t1 and f_t2 are each other's negatives and p_4 = 0, so
// several variables often block at once, and a careless choice among them can cycle. Replace p' by
// p' + (t, t^2, t^3, t^4), t > 0 infinitely small: ties are settled by the columns of w, which hold
// the inverse of the basis, and no basis comes twice. z_0 wins its ties, as that is the end.
//
// Why it ends well. For z >= 0, z^T V z = f^T (J_hat^T M^-1 J_hat dt) f + mu lambda f_n >= 0, so V
// is copositive, and a ray needs a u >= 0, not 0, with V u >= 0, u^T V u = 0 and p^T u < 0. Then
// u^T V u = 0 makes J_hat f = 0, so f_n = 0 and f_t1 = f_t2; the last row of V u >= 0 makes these 0
// too. Only lambda is left in u, and p_4 = 0, so p^T u = 0: no ray. Another V may have one.
//   Cottle, Pang & Stone, The Linear Complementarity Problem (1992), chapter 4: the method, its
//   rays when the matrix is copositive, degeneracy. Stewart & Trinkle (1996) and Anitescu & Potra
//   (1997) use it for contact with friction, and prove that it ends with a solution there.
#include <algorithm>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace bounce {
namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double kTolerance = 1e-12;  // of the problem's scale, see residual()
// What a few pivots may add by rounding to an entry of size 1. With 0, some ten contacts in a
// million end on a false ray. The larger, the more numbers that differ count as equal, and the
// larger the residual: 1e-13 at most for contacts now.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
constexpr int kMaxPivots = 50;  // only 32 bases hold z_0, and most contacts take 3 or 4 pivots

// The scaling, with functions that scale w, p and z.
struct Scaling {
  Vector4d d;
  double s;
  Vector4d of_w(const Vector4d& w) const { return d.cwiseProduct(w / s); }
  Vector4d of_z(const Vector4d& z) const { return (z / s).cwiseQuotient(d); }
};

double power_of_two(double x) { return std::ldexp(1.0, std::ilogb(x)); }  // in (x/2, x]

double inverse_of_size(double x) { return x > 0.0 ? 1.0 / power_of_two(x) : 1.0; }

// The largest |V_ij| or |V_ji| over j, each times the weight of j.
double largest(const Matrix4d& V, Index i, const Vector4d& weights) {
  double size = 0.0;
  for (Index j = 0; j < 4; ++j)
    size = std::max(size, weights(j) * std::max(std::abs(V(i, j)), std::abs(V(j, i))));
  return size;
}

Scaling equilibrate(const Matrix4d& V, const Vector4d& p) {
  const Vector4d has_diagonal = (V.diagonal().array() != 0.0).cast<double>();
  Vector4d d = Vector4d::Zero();
  for (Index i = 0; i < 4; ++i)
    if (V(i, i) != 0.0) d(i) = inverse_of_size(std::sqrt(largest(V, i, has_diagonal)));
  for (Index i = 0; i < 4; ++i)
    if (V(i, i) == 0.0) d(i) = inverse_of_size(largest(V, i, d));
  return {d, power_of_two(d.cwiseProduct(p).cwiseAbs().maxCoeff())};
}

// Columns p, w_1 .. w_4, z_1 .. z_4, z_0; a row for each basic variable.
using Tableau = Eigen::Matrix<double, 4, 10>;
constexpr Index kW = 1, kZ = 5, kZ0 = 9;

struct Lemke {
  Tableau T;
  Eigen::Matrix<Index, 4, 1> basic{kW, kW + 1, kW + 2, kW + 3};

  // Lets a variable enter the basis in a row, and returns the one that leaves it.
  Index pivot(Index row, Index entering) {
    const Vector4d column = T.col(entering);
    for (Index k = 0; k < T.cols(); ++k) {
      const double t = T(row, k) / column(row);
      T.col(k) -= t * column;
      T(row, k) = t;
    }
    return std::exchange(basic(row), entering);
  }

  // Whether row i blocks the entering variable before row j does. Compares ratios by
  // cross-multiplication.
  bool blocks_before(Index i, Index j, Index entering) const {
    const double t_i = T(i, entering), t_j = T(j, entering);
    for (Index k = 0; k < kZ; ++k) {
      const double a = T(i, k) * t_j, b = T(j, k) * t_i;
      if (std::abs(a - b) > kRounding * (std::abs(a) + std::abs(b) + t_i + t_j)) return a < b;
      if (basic(i) == kZ0 || basic(j) == kZ0) return basic(i) == kZ0;
    }
    return false;
  }

  // The row that blocks the entering variable first, or -1 on a ray.
  Index blocking_row(Index entering) const {
    const double zero = kRounding * T.col(entering).cwiseAbs().maxCoeff();
    Index row = -1;
    for (Index i = 0; i < 4; ++i)
      if (T(i, entering) > zero && (row < 0 || blocks_before(i, row, entering))) row = i;
    return row;
  }

  void run() {
    Index row = 0;  // of the least p'; the last of equals, whose power of t is the least
    for (Index i = 1; i < 4; ++i)
      if (T(i, 0) <= T(row, 0)) row = i;
    Index leaving = pivot(row, kZ0);
    for (int n = 0; n < kMaxPivots && leaving != kZ0; ++n) {
      const Index entering = leaving < kZ ? leaving + 4 : leaving - 4;
      row = blocking_row(entering);
      if (row < 0) return;
      leaving = pivot(row, entering);
    }
  }
};

// z' of the basis B where Lemke's path ends. Solves B x = p' again from the original numbers, by
// the inverse in the tableau and a step of refinement. On a ray z_0 counts as 0.
Vector4d follow_path(const Matrix4d& V, const Vector4d& p) {
  Tableau start;
  start << p, Matrix4d::Identity(), -V, -Vector4d::Ones();
  Lemke lemke{start};
  lemke.run();
  Matrix4d B;
  for (Index i = 0; i < 4; ++i) B.col(i) = start.col(lemke.basic(i));
  const Matrix4d inverse = lemke.T.middleCols<4>(kW);
  Vector4d x = inverse * p;
  x += inverse * (p - B * x);
  Vector4d z = Vector4d::Zero();
  for (Index i = 0; i < 4; ++i)
    if (lemke.basic(i) >= kZ && lemke.basic(i) != kZ0) z(lemke.basic(i) - kZ) = std::max(x(i), 0.0);
  return z;
}

// max_i |min(z'_i, w'_i)|, 0 for solutions only, as a part of the problem's scale: the largest of
// the sums |p'| + |V'| z' that make w', since rounding grows with them. |p'| is 1 to 2, and the
// scale at most 1e6, so that a huge z' of a nearly singular V can't hide p'. Overflow counts as
// infinite.
double residual(const Matrix4d& V, const Vector4d& p, const Vector4d& z, const Scaling& scaling) {
  const Vector4d z_scaled = scaling.of_z(z), w_scaled = scaling.of_w(V * z + p);
  const Vector4d sums = scaling.of_w(V.cwiseAbs() * z + p.cwiseAbs());
  if (!z_scaled.allFinite() || !sums.allFinite()) return std::numeric_limits<double>::infinity();
  return z_scaled.cwiseMin(w_scaled).cwiseAbs().maxCoeff() / std::min(sums.maxCoeff(), 1e6);
}

[[noreturn]] void refuse(double residual) {
  std::ostringstream message;
  message << "solve_lcp: no solution found, residual " << residual << " of the problem's scale";
  throw std::runtime_error(message.str());
}

}  // namespace

Vector3 solve_lcp(const Matrix4d& V, const Vector4d& p) {
  if (!V.allFinite()) throw std::invalid_argument("solve_lcp: V holds NaN or infinity");
  if (!p.allFinite()) throw std::invalid_argument("solve_lcp: p holds NaN or infinity");
  if ((p.array() >= 0.0).all()) return Vector3::Zero();
  const Scaling scaling = equilibrate(V, p);
  const Matrix4d V_scaled = scaling.d.asDiagonal() * V * scaling.d.asDiagonal();
  const Vector4d z_scaled = follow_path(V_scaled, scaling.of_w(p));
  const Vector4d z = scaling.s * scaling.d.cwiseProduct(z_scaled);
  const double error = residual(V, p, z, scaling);
  if (!(error <= kTolerance)) refuse(error);
  return z.head<3>();
}

}  // namespace bounce
