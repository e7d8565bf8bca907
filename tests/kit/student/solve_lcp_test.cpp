// The given LCP solver, judged by a second solution in closed form, case by case, and by residuals.
#include <gtest/gtest.h>

#include <algorithm>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace bounce::tests {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const std::string kUnsolved = "solve_lcp: no solution found, residual ";

// The numbers that V and p of eqs. (9) and (10) are made of.
struct Numbers {
  double a, b, c;   // dt J_n^T M^-1 J_n, dt J_n^T M^-1 J_t, dt J_t^T M^-1 J_t, s/kg
  double u_n, u_t;  // p(0), and the tangential velocity without contact, m/s
  double mu;
};

std::mt19937_64 engine;  // each test seeds it

bool one_in(unsigned n) { return engine() % n == 0; }
double uniform(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine); }
double logarithmic(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
double integer(int a, int b) { return std::uniform_int_distribution<int>(a, b)(engine); }
// Often nothing, or nearly so: corners that graze, hardly slide, or do neither.
double speed() {
  const double size = one_in(4) ? (one_in(2) ? 0.0 : logarithmic(1e-18, 1.0)) : 1.0;
  return size * uniform(-5.0, 5.0);
}

// Of a square that stands on a corner or lies flat, to rounding, or turned in any way; x and y
// lead to its lowest corner, and are parts of its side.
Numbers contact(bool is_extreme = false) {
  const double s = is_extreme ? logarithmic(1e-12, 1e3) : 1.0;  // dt / m
  const double angle = std::atan(1.0) * (one_in(4) ? integer(-1, 1) : uniform(-1.0, 1.0));
  const double x = std::sqrt(0.5) * std::sin(angle), y = -std::sqrt(0.5) * std::cos(angle);
  const double scale = is_extreme ? logarithmic(1e-9, 1e9) : 1.0;
  const double u_n = scale * speed(), u_t = scale * speed();
  double mu = uniform(0.0, 1.3);
  if (one_in(4)) mu = one_in(2) ? 0.0 : logarithmic(1e-16, 1.3);
  return {s * (1.0 + 6.0 * x * x), -s * 6.0 * x * y, s * (1.0 + 6.0 * y * y), u_n, u_t, mu};
}

Lcp form(const Numbers& n) {
  Lcp lcp;
  lcp.V << n.a, -n.b, n.b, 0.0, -n.b, n.c, -n.c, 1.0, n.b, -n.c, n.c, 1.0, n.mu, -1.0, -1.0, 0.0;
  lcp.p << n.u_n, -n.u_t, n.u_t, 0.0;
  return lcp;
}

// f_n, and f_t2 - f_t1, the friction along t; unique while a > mu |b|, that is while mu < 4/3 for a
// square.
std::pair<double, double> by_cases(const Numbers& n) {
  if (n.u_n >= 0.0) return {0.0, 0.0};
  const double determinant = n.a * n.c - n.b * n.b;
  const double f_n = (n.b * n.u_t - n.c * n.u_n) / determinant;
  const double f = (n.b * n.u_n - n.a * n.u_t) / determinant;
  if (std::abs(f) <= n.mu * f_n) return {f_n, f};
  const double left = -n.u_n / (n.a + n.mu * n.b), right = -n.u_n / (n.a - n.mu * n.b);
  if (n.u_t + (n.b - n.mu * n.c) * right > 0.0) return {right, -n.mu * right};
  return {left, n.mu * left};
}

// max_i |min(z_i, w_i)| of a problem of size 1, as a part of the largest sum of terms that makes a
// w_i: rounding grows with that sum. It counts up to a million times p, so that no huge answer that
// has nothing to do with p is accepted.
double residual(const Lcp& lcp, const Vector4d& z) {
  const Vector4d w = lcp.V * z + lcp.p, sums = lcp.V.cwiseAbs() * z + lcp.p.cwiseAbs();
  if (!z.allFinite() || !sums.allFinite()) return kInfinity;
  return z.cwiseMin(w).cwiseAbs().maxCoeff() / std::min(sums.maxCoeff(), 1e6);
}

// The solver keeps lambda to itself. The lambdas that suit f are an interval; if it isn't empty, it
// starts at 0 or where a w_i is 0, so these are tried.
double residual(const Lcp& lcp, const Vector3& f) {
  if (lcp.p.isZero(0.0)) return f.isZero(0.0) ? 0.0 : kInfinity;
  Vector4d z(f.x(), f.y(), f.z(), 0.0);
  const Vector4d w = lcp.V * z + lcp.p;
  double least = residual(lcp, z);
  for (int i = 0; i < 4; ++i) {
    z(3) = -w(i) / lcp.V(i, 3);
    if (z(3) > 0.0) least = std::min(least, residual(lcp, z));
  }
  return least;
}

// The solver promises a right answer, or an exception with the residual; this is what it says. Its
// 1e-12 is in units of its own, so it may be somewhat more in these.
std::string refusal(const Matrix4d& V, const Vector4d& p) {
  try {
    const double error = residual({V, p}, solve_lcp(V, p));
    EXPECT_LE(error, 1e-11) << "V =\n" << V << "\np = " << p.transpose();
    return "";
  } catch (const std::invalid_argument& exception) {
    return std::string("invalid argument: ") + exception.what();
  } catch (const std::runtime_error& exception) {
    return exception.what();
  }
}

TEST(solve_lcp, SolvesEveryContactAsItsCasesDo) {
  engine.seed(1);
  std::map<std::string, int> occurred;
  for (int i = 0; i < 500'000; ++i) {
    Numbers n = contact(one_in(2));
    const bool grazes = one_in(16);  // and so has a small force
    if (grazes) n.u_n = -1e-9 * std::abs(n.u_t);
    const auto [f_n, friction] = by_cases(n);
    const auto [V, p] = form(n);
    const Vector3 f = solve_lcp(V, p);
    const double size = std::max(std::abs(n.u_n), std::abs(n.u_t)) / std::max(n.a, n.c);
    ASSERT_GE(f.minCoeff(), 0.0);
    ASSERT_NEAR(f(0), f_n, grazes ? 1e-12 * f_n : 1e-11 * size) << V << "\np = " << p.transpose();
    ASSERT_NEAR(f(2) - f(1), friction, 1e-11 * size) << V << "\np = " << p.transpose();
    const bool sticks = std::abs(friction) < n.mu * f_n;
    ++occurred[f_n == 0.0 ? "separates" : sticks ? "sticks" : friction > 0.0 ? "left" : "right"];
  }
  EXPECT_EQ(occurred.size(), 4u);
  for (const auto& [how, times] : occurred) EXPECT_GT(times, 25'000) << how << " is left out";
}

TEST(solve_lcp, SolvesOrRefusesWhateverTheMatrix) {
  engine.seed(4);
  const auto real = [] { return uniform(-1.0, 1.0); };
  const auto small_integer = [] { return integer(-2, 2); };
  int solved = 0;
  const auto solve = [&solved](const Matrix4d& V, const Vector4d& p) {
    const std::string said = refusal(V, p);
    EXPECT_TRUE(said.empty() || said.find(kUnsolved) == 0) << said;
    solved += said.empty();
  };
  for (int i = 0; i < 50'000; ++i) {
    const Matrix4d V = Matrix4d::NullaryExpr(real);
    const Vector4d p = Vector4d::NullaryExpr(real);
    const Lcp definite{V * V.transpose() + 1e-3 * Matrix4d::Identity(), p};
    ASSERT_LE(residual(definite, solve_lcp(definite.V, p)), 2e-15) << definite.V;  // of rounding
    Matrix4d without_diagonal = V;
    without_diagonal.diagonal() *= one_in(2) ? 0.0 : logarithmic(1e-18, 1.0);
    for (const Matrix4d& matrix : {V, Matrix4d(V.row(0).transpose() * V.row(1)), without_diagonal,
                                   Matrix4d(V.leftCols<2>() * V.leftCols<2>().transpose())})
      solve(matrix, p);
    const Matrix4d integers = Matrix4d::NullaryExpr(small_integer);
    solve(integers, Vector4d::NullaryExpr(small_integer));

    const Lcp right = form(contact());  // and mistakes made of it
    Matrix4d unbounded = right.V, shuffled = right.V, regular = right.V;
    unbounded.col(3).setZero();
    shuffled.col(0).swap(shuffled.col(2));
    regular.topLeftCorner<3, 3>().diagonal().array() += 1e-9;
    for (const Matrix4d& mistaken : {Matrix4d(right.V.transpose()), Matrix4d(-right.V), unbounded,
                                     shuffled, regular, Matrix4d(Matrix4d::Zero())})
      solve(mistaken, right.p);
  }
  EXPECT_GT(solved, 50'000);
}

// Lemke's method can cycle here: three tie in turn, one is idle.
TEST(solve_lcp, SolvesWhatTiesInTurn) {
  Matrix4d cycles = Matrix4d::Identity();
  cycles(0, 1) = cycles(1, 2) = cycles(2, 0) = 2.0;
  const Vector3 thirds = Vector3::Constant(1.0 / 3.0);
  EXPECT_LE((solve_lcp(cycles, {-1.0, -1.0, -1.0, 0.0}) - thirds).norm(), 1e-15);
}

TEST(solve_lcp, SaysWhyItRefuses) {
  const Matrix4d one = Matrix4d::Identity();
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 4; ++i) {
      Matrix4d V = one;
      Vector4d p = Vector4d::Ones();
      p(i) = bad;
      EXPECT_EQ(refusal(V, p), "invalid argument: solve_lcp: p holds NaN or infinity");
      V(3 - i, i) = bad;
      EXPECT_EQ(refusal(V, p), "invalid argument: solve_lcp: V holds NaN or infinity");
    }
  }
  Matrix4d attracting = Matrix4d::Zero(), never_zero = Matrix4d::Zero();
  attracting(0, 0) = -1.0;
  never_zero(0, 0) = -1e-300;
  never_zero(0, 2) = -1e300;
  for (const Matrix4d& V : {Matrix4d(Matrix4d::Zero()), attracting})
    EXPECT_EQ(refusal(V, {-1.0, 0.0, 0.0, 0.0}), kUnsolved + "1 of the problem's scale");
  for (const auto& [V, p] : {
           std::tuple<Matrix4d, Vector4d>{1e-300 * one, Vector4d::Constant(-1e300)},  // overflows
           {1e300 * one, Vector4d::Constant(-1e-300)},                                // vanishes
           {1e-320 * one, Vector4d::Constant(-1.0)},
           {never_zero, {1e-200, 0.0, -1e-300, 0.0}},
       })
    EXPECT_EQ(refusal(V, p).find(kUnsolved), 0u) << V << "\np = " << p.transpose();
}

}  // namespace
}  // namespace bounce::tests
