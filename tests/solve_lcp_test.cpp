// The given LCP solver. Each test is a fact, and judges by what the forces do, not by how they were
// found. V and p are formed here, entry by entry, from eqs. (9) and (10).
#include <gtest/gtest.h>
#include <bounce/solve_lcp.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

namespace bounce::tests {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class Random {
 public:
  explicit Random(unsigned long long seed) : engine_(seed) {}
  bool one_in(unsigned n) { return engine_() % n == 0; }
  int integer(int a, int b) { return std::uniform_int_distribution<int>(a, b)(engine_); }
  double uniform(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine_); }
  double logarithmic(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
  Matrix4d matrix() {
    return Matrix4d::NullaryExpr([this] { return uniform(-1.0, 1.0); });
  }
  Vector4d vector() {
    return Vector4d::NullaryExpr([this] { return uniform(-1.0, 1.0); });
  }

 private:
  std::mt19937_64 engine_;
};

// --- contacts ---

struct Scene {
  double r_x, r_y;  // from the centre to the lowest corner, m
  Vector3 v;
  Parameters params;
};

// The lowest of the four corners at this angle, eqs. (3) to (5).
void turn(Scene& scene, double theta) {
  const double x = scene.params.l / 2 * (std::cos(theta) - std::sin(theta));
  const double y = scene.params.l / 2 * (std::cos(theta) + std::sin(theta));
  scene.r_y = kInfinity;
  for (const auto& [r_x, r_y] : {std::pair{x, y}, {-y, x}, {-x, -y}, {y, -x}})
    if (r_y < scene.r_y) scene.r_x = r_x, scene.r_y = r_y;
}

// Components of v that are nothing or nearly so, and corners that graze or hardly slide.
void make_degenerate(Random& random, Scene& scene) {
  Vector3& v = scene.v;
  for (double& component : v)
    if (random.one_in(4)) component *= random.one_in(2) ? 0.0 : random.logarithmic(1e-18, 1.0);
  const double tiny = random.one_in(2) ? 0.0 : random.logarithmic(1e-18, 1e-3);
  if (random.one_in(2)) v.y() = -scene.r_x * v.z() - tiny;
  if (random.one_in(2)) v.x() = scene.r_y * v.z() + tiny;
}

double any_friction(Random& random) {
  if (random.one_in(8)) return 0.0;
  return random.one_in(8) ? random.logarithmic(1e-16, 1.3) : random.uniform(0.0, 1.3);
}

Vector3 any_gravity(Random& random) {
  if (random.one_in(2)) return {0.0, -9.81, 0.0};
  return {random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0), 0.0};
}

// A quarter of the squares stands on a corner or lies flat, to rounding.
Scene any_scene(Random& random, double m, double dt) {
  const double l = random.logarithmic(1e-3, 50.0), spin = random.one_in(8) ? 100.0 : 5.0;
  const double epsilon = random.one_in(4) ? random.integer(0, 1) : random.uniform(0.0, 1.0);
  const double v_x = random.uniform(-5.0, 5.0), v_y = random.uniform(-5.0, 5.0);
  const Vector3 v(v_x, v_y, random.uniform(-spin, spin) / l);
  const double mu = any_friction(random);
  Scene scene{0.0, 0.0, v, Parameters{l, m, mu, epsilon, any_gravity(random), dt}};
  const double eighth = std::atan(1.0);
  turn(scene, random.one_in(4) ? random.integer(-8, 8) * eighth : random.uniform(-10.0, 10.0));
  if (random.one_in(4)) make_degenerate(random, scene);
  return scene;
}

Scene any_scene(Random& random) {
  const double m = random.logarithmic(1e-2, 1e2);
  return any_scene(random, m, random.logarithmic(1e-4, 1e-1));
}

// Masses from 1e-9 kg to 1e9 kg, and dt / m down to 1e-12 s/kg or less.
Scene extreme_scene(Random& random) {
  const double m = random.logarithmic(1e-9, 1e9);
  return any_scene(
      random, m,
      random.one_in(2) ? random.logarithmic(1e-6, 1.0) : m * random.logarithmic(1e-12, 1e3));
}

// The numbers that V and p are made of, with J_t = (1, 0, -r_y) and J_n = (0, 1, r_x), eq. (6).
struct Numbers {
  double a, b, c;    // dt J_n^T M^-1 J_n, dt J_n^T M^-1 J_t, dt J_t^T M^-1 J_t, s/kg
  double p_n, slip;  // p(0), and the sliding velocity if there were no contact, m/s
  double mu;
};

Numbers numbers(const Scene& scene) {
  const Parameters& params = scene.params;
  const double x = scene.r_x, y = scene.r_y;
  const double per_mass = params.dt / params.m, s = 6.0 / (params.l * params.l);
  const Vector3 &v = scene.v, pull = params.dt * params.g;
  return {per_mass * (1.0 + s * x * x),
          -per_mass * s * x * y,
          per_mass * (1.0 + s * y * y),
          (1.0 + params.epsilon) * (v.y() + x * v.z()) + pull.y() + x * pull.z(),
          v.x() - y * v.z() + pull.x() - y * pull.z(),
          params.mu};
}

Lcp form(const Numbers& n) {
  Lcp lcp;
  lcp.V << n.a, -n.b, n.b, 0.0, -n.b, n.c, -n.c, 1.0, n.b, -n.c, n.c, 1.0, n.mu, -1.0, -1.0, 0.0;
  lcp.p << n.p_n, -n.slip, n.slip, 0.0;
  return lcp;
}

Vector3 solve(const Lcp& lcp) { return solve_lcp(lcp.V, lcp.p); }

Vector3 solve(const Scene& scene) { return solve(form(numbers(scene))); }

// --- judging by residual ---

// The sizes that velocities and forces of a problem are counted in: p, and what V makes of it.
struct Units {
  double velocity, force;
};

Units units(const Lcp& lcp) {
  const double velocity = lcp.p.cwiseAbs().maxCoeff(), a = lcp.V.diagonal().cwiseAbs().maxCoeff();
  return {velocity, a > 0.0 ? velocity / a : velocity};
}

// max_i |min(z_i, w_i)|, each in its unit, as a part of the largest sum of terms that makes a w_i:
// rounding grows with that sum. It counts up to a million times p, so that no answer is right that
// is huge and has nothing to do with p.
double residual(const Lcp& lcp, const Vector4d& z, const Units& unit) {
  const Vector4d of_z(unit.force, unit.force, unit.force, unit.velocity);
  const Vector4d of_w(unit.velocity, unit.velocity, unit.velocity, unit.force);
  const Vector4d w = lcp.V * z + lcp.p, sums = lcp.V.cwiseAbs() * z + lcp.p.cwiseAbs();
  if (!z.allFinite() || !sums.allFinite()) return kInfinity;
  const Vector4d least = z.cwiseQuotient(of_z).cwiseMin(w.cwiseQuotient(of_w));
  return least.cwiseAbs().maxCoeff() / std::min(sums.cwiseQuotient(of_w).maxCoeff(), 1e6);
}

// The solver keeps lambda to itself. The lambdas that suit f are an interval; if it isn't empty, it
// starts at 0 or where a w_i is 0, so these are tried.
double residual(const Lcp& lcp, const Vector3& f, const Units& unit) {
  if (lcp.p.isZero(0.0)) return f.isZero(0.0) ? 0.0 : kInfinity;
  Vector4d z(f.x(), f.y(), f.z(), 0.0);
  const Vector4d w = lcp.V * z + lcp.p;
  double least = residual(lcp, z, unit);
  for (int i = 0; i < 4; ++i) {
    z(3) = -w(i) / lcp.V(i, 3);
    if (z(3) > 0.0) least = std::min(least, residual(lcp, z, unit));
  }
  return least;
}

// Infinite where the solver refuses.
double residual(const Lcp& lcp) {
  try {
    return residual(lcp, solve(lcp), units(lcp));
  } catch (const std::runtime_error&) {
    return kInfinity;
  }
}

// What the solver promises for any V and p: a right answer, or an exception with the residual. Its
// 1e-12 is in units of its own, so it may be somewhat more in these.
bool solves_or_refuses(const Lcp& lcp, const Units& unit) {
  try {
    const double error = residual(lcp, solve(lcp), unit);
    EXPECT_LE(error, 1e-11) << "V =\n" << lcp.V << "\np = " << lcp.p.transpose();
    return true;
  } catch (const std::runtime_error& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("residual"), std::string::npos) << refusal.what();
    return false;
  }
}

// --- a second opinion, case by case ---

enum Case { separates, sticks, slides_left, slides_right };

struct Answer {
  Case happens;
  double f_n, f;  // f = f_t2 - f_t1 is the friction along t
};

// Unique while a > mu |b|, that is while mu < 4/3 for a square.
Answer by_cases(const Numbers& n) {
  if (n.p_n >= 0.0) return {separates, 0.0, 0.0};
  const double determinant = n.a * n.c - n.b * n.b;
  const double f_n = (n.b * n.slip - n.c * n.p_n) / determinant;
  const double f = (n.b * n.p_n - n.a * n.slip) / determinant;
  if (std::abs(f) <= n.mu * f_n) return {sticks, f_n, f};
  const double left = -n.p_n / (n.a + n.mu * n.b), right = -n.p_n / (n.a - n.mu * n.b);
  if (n.slip + (n.b - n.mu * n.c) * right > 0.0) return {slides_right, right, -n.mu * right};
  return {slides_left, left, n.mu * left};
}

// v_{t+1}, eq. (13), with l omega in place of omega, so that all three are m/s.
Vector3 velocity_after(const Scene& scene, double f_n, double f) {
  const Parameters& params = scene.params;
  const double moment = scene.r_x * f_n - scene.r_y * f, s = 6.0 / (params.l * params.l);
  const Vector3 change = params.dt / params.m * Vector3(f, f_n, s * moment);
  return (scene.v + params.dt * params.g + change).cwiseProduct(Vector3(1.0, 1.0, params.l));
}

// How far v_{t+1} is from the second opinion's, as a part of the larger of it and the free step's.
double disagreement(const Scene& scene) {
  const Vector3 f = solve(scene);
  const Answer answer = by_cases(numbers(scene));
  const Vector3 expected = velocity_after(scene, answer.f_n, answer.f);
  const double size = std::max(expected.norm(), velocity_after(scene, 0.0, 0.0).norm());
  return (velocity_after(scene, f(0), f(2) - f(1)) - expected).norm() / size;
}

// --- the facts ---

TEST(solve_lcp, SolvesAMillionContactsByResidual) {
  Random random(1);
  std::array<int, 4> happened{};
  double worst = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Numbers n = numbers(any_scene(random));
    ++happened[by_cases(n).happens];
    const double error = residual(form(n));
    ASSERT_LE(error, 1e-12) << "contact " << i << ", V =\n"
                            << form(n).V << "\np = " << form(n).p.transpose();
    worst = std::max(worst, error);
  }
  RecordProperty("worst_residual", testing::PrintToString(worst));
  for (const int times : happened) EXPECT_GT(times, 50'000) << "the contacts leave a case out";
}

TEST(solve_lcp, SolvesExtremeScales) {
  Random random(2);
  for (int i = 0; i < 200'000; ++i) {
    const Lcp lcp = form(numbers(extreme_scene(random)));
    ASSERT_LE(residual(lcp), 1e-12) << "V =\n" << lcp.V << "\np = " << lcp.p.transpose();
  }
}

TEST(solve_lcp, AgreesWithTheClosedFormOfEachCase) {
  Random random(3);
  for (int i = 0; i < 200'000; ++i) {
    const Scene scene = i % 2 ? any_scene(random) : extreme_scene(random);
    ASSERT_LE(disagreement(scene), 1e-9)
        << "scene " << i << ", case " << by_cases(numbers(scene)).happens;
  }
}

TEST(solve_lcp, KeepsTheSmallForceOfAGrazingContact) {
  Random random(10);
  for (int i = 0; i < 10'000; ++i) {
    Numbers n = numbers(any_scene(random));
    n.p_n = -1e-9 * std::abs(n.slip);
    ASSERT_NEAR(solve(form(n))(0), by_cases(n).f_n, 1e-12 * by_cases(n).f_n) << "contact " << i;
  }
}

TEST(solve_lcp, SolvesAProblemOnWhichLemkesMethodCanCycle) {
  Matrix4d V = Matrix4d::Identity();  // three variables tie in turn; the fourth is idle
  V(0, 1) = V(1, 2) = V(2, 0) = 2.0;
  const Vector3 f = solve_lcp(V, Vector4d(-1.0, -1.0, -1.0, 0.0));
  EXPECT_LE((f - Vector3::Constant(1.0 / 3.0)).norm(), 1e-15) << f.transpose();
}

TEST(solve_lcp, LeavesASeparatingCornerAlone) {
  EXPECT_EQ(solve(form({2.0, 0.5, 3.0, 0.0, -4.0, 0.3})), Vector3::Zero()) << "p(1) >= 0 > p(2)";
  EXPECT_EQ(solve_lcp(-Matrix4d::Ones(), Vector4d(1.0, 0.0, 2.0, 0.0)), Vector3::Zero());
  EXPECT_EQ(solve_lcp(Matrix4d::Zero(), Vector4d::Zero()), Vector3::Zero());
}

TEST(solve_lcp, GivesNoFrictionWithoutMu) {
  Random random(4);
  for (int i = 0; i < 10'000; ++i) {
    Scene scene = any_scene(random);
    scene.params.mu = 0.0;
    const Numbers n = numbers(scene);
    const Vector3 f = solve(scene);
    const double f_n = std::max(0.0, -n.p_n / n.a), size = units(form(n)).force;
    ASSERT_LE((f - Vector3(f_n, 0.0, 0.0)).norm(), 1e-12 * size) << f.transpose();
  }
}

TEST(solve_lcp, MirrorsTheForcesOfAMirroredContact) {
  Random random(5);
  for (int i = 0; i < 10'000; ++i) {
    const Scene scene = any_scene(random);
    Scene mirrored = scene;
    mirrored.r_x *= -1.0;
    mirrored.v.x() *= -1.0;
    mirrored.v.z() *= -1.0;
    mirrored.params.g.x() *= -1.0;
    const Vector3 f = solve(scene), g = solve(mirrored);
    const double size = units(form(numbers(scene))).force;
    ASSERT_NEAR(f(0), g(0), 1e-11 * size);
    ASSERT_NEAR(f(2) - f(1), g(1) - g(2), 1e-11 * size);
  }
}

TEST(solve_lcp, ScalesForcesWithTheUnits) {
  Random random(6);
  for (int i = 0; i < 10'000; ++i) {
    const Lcp lcp = form(numbers(any_scene(random)));
    const double velocity = random.logarithmic(1e-9, 1e9), force = random.logarithmic(1e-9, 1e9);
    Lcp scaled = lcp;
    scaled.V.topLeftCorner<3, 3>() *= velocity / force;
    scaled.p *= velocity;
    const Vector3 f = solve(lcp), g = solve(scaled) / force;
    ASSERT_NEAR(f(0), g(0), 1e-11 * units(lcp).force);
    ASSERT_NEAR(f(2) - f(1), g(2) - g(1), 1e-11 * units(lcp).force);
  }
}

TEST(solve_lcp, SolvesEveryPositiveDefiniteProblemToRounding) {
  Random random(7);
  for (int i = 0; i < 50'000; ++i) {
    const Matrix4d A = random.matrix();
    const Lcp lcp{A * A.transpose() + 1e-3 * Matrix4d::Identity(), random.vector()};
    ASSERT_LE(residual(lcp, solve(lcp), {1.0, 1.0}), 2e-15)
        << lcp.V << "\np = " << lcp.p.transpose();
  }
}

TEST(solve_lcp, SolvesOrRefusesWhateverTheMatrix) {
  Random random(8);
  const auto small_integer = [&random] { return double(random.integer(-2, 2)); };
  int solved = 0;
  for (int i = 0; i < 50'000; ++i) {
    const Matrix4d V = random.matrix();
    const Vector4d p = random.vector();
    Matrix4d without_diagonal = V;
    without_diagonal.diagonal() *= random.one_in(2) ? 0.0 : random.logarithmic(1e-18, 1.0);
    for (const Matrix4d& matrix : {V, Matrix4d(V.row(0).transpose() * V.row(1)), without_diagonal,
                                   Matrix4d(V.leftCols<2>() * V.leftCols<2>().transpose())})
      solved += solves_or_refuses({matrix, p}, {1.0, 1.0});
    solved += solves_or_refuses(
        {Matrix4d::NullaryExpr(small_integer), Vector4d::NullaryExpr(small_integer)}, {1.0, 1.0});
  }
  EXPECT_GT(solved, 50'000);
}

TEST(solve_lcp, SolvesOrRefusesMistakenContacts) {
  Random random(9);
  for (int i = 0; i < 20'000; ++i) {
    const Lcp right = form(numbers(any_scene(random)));
    Lcp transposed = right, unbounded = right, negative = right, shuffled = right, regular = right;
    transposed.V.transposeInPlace();
    unbounded.V.col(3).setZero();
    negative.V *= -1.0;
    shuffled.V.col(0).swap(shuffled.V.col(2));
    regular.V.topLeftCorner<3, 3>().diagonal().array() += 1e-9;
    for (const Lcp& lcp : {transposed, unbounded, negative, shuffled, regular})
      solves_or_refuses(lcp, units(lcp));
    solves_or_refuses({Matrix4d::Zero(), right.p}, units(right));
  }
}

// What the solver says when it refuses with this kind of exception.
template <class Exception>
std::string refusal(const Matrix4d& V, const Vector4d& p) {
  try {
    solve_lcp(V, p);
  } catch (const Exception& exception) {
    return exception.what();
  }
  return "no exception";
}

TEST(solve_lcp, NamesWhatHoldsNanOrInfinity) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 4; ++i) {
      Matrix4d V = Matrix4d::Identity();
      Vector4d p = Vector4d::Ones();
      p(i) = bad;
      EXPECT_EQ(refusal<std::invalid_argument>(V, p), "solve_lcp: p holds NaN or infinity");
      V(3 - i, i) = bad;
      EXPECT_EQ(refusal<std::invalid_argument>(V, p), "solve_lcp: V holds NaN or infinity");
    }
  }
}

TEST(solve_lcp, RefusesWhereThereIsNoSolutionAndNamesTheResidual) {
  const Vector4d p(-1.0, 0.0, 0.0, 0.0);
  Matrix4d attracting = Matrix4d::Zero();
  attracting(0, 0) = -1.0;
  for (const Matrix4d& V : {Matrix4d(Matrix4d::Zero()), attracting})
    EXPECT_EQ(refusal<std::runtime_error>(V, p),
              "solve_lcp: no solution found, residual 1 of the problem's scale");
}

TEST(solve_lcp, RefusesWhatOverflowsOrVanishes) {
  const auto refuses = [](const Matrix4d& V, const Vector4d& p) {
    return refusal<std::runtime_error>(V, p).find("residual") != std::string::npos;
  };
  for (const auto& [v, p] : {std::pair{1e-300, -1e300}, {1e300, -1e-300}, {1e-320, -1.0}})
    EXPECT_TRUE(refuses(v * Matrix4d::Identity(), Vector4d::Constant(p))) << v << " f = " << -p;
  Matrix4d V = Matrix4d::Zero();
  V(0, 0) = -1e-300;
  V(0, 2) = -1e300;
  EXPECT_TRUE(refuses(V, Vector4d(1e-200, 0.0, -1e-300, 0.0))) << "the third row is never 0";
}

}  // namespace
}  // namespace bounce::tests
