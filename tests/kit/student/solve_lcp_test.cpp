// The given LCP solver. Each test is a fact, and judges by what the forces do, not by how they were
// found.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "lcp_answers.hpp"
#include "random_contacts.hpp"

namespace bounce::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Vector3 solve(const Lcp& lcp) { return solve_lcp(lcp.V, lcp.p); }

Vector3 solve(const Scene& scene) { return solve(form(numbers(scene))); }

// Infinite where the solver refuses.
double residual_of_solution(const Lcp& lcp) {
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

// How far v_{t+1} is from the second opinion's, as a part of the larger of it and the free step's.
double disagreement(const Scene& scene) {
  const Vector3 f = solve(scene);
  const ContactForces answer = by_cases(numbers(scene));
  const Vector3 expected = velocity_after(scene, answer.f_n, answer.f);
  const double size = std::max(expected.norm(), velocity_after(scene, 0.0, 0.0).norm());
  return (velocity_after(scene, f(0), f(2) - f(1)) - expected).norm() / size;
}

TEST(solve_lcp, SolvesAMillionContactsByResidual) {
  Random random(1);
  std::array<int, 4> occurred{};
  double worst = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Numbers n = numbers(any_scene(random));
    ++occurred[by_cases(n).mode];
    const double error = residual_of_solution(form(n));
    ASSERT_LE(error, 1e-12) << "contact " << i << ", V =\n"
                            << form(n).V << "\np = " << form(n).p.transpose();
    worst = std::max(worst, error);
  }
  RecordProperty("worst_residual", testing::PrintToString(worst));
  for (const int times : occurred) EXPECT_GT(times, 50'000) << "the contacts leave a case out";
}

TEST(solve_lcp, SolvesExtremeScales) {
  Random random(2);
  for (int i = 0; i < 200'000; ++i) {
    const Lcp lcp = form(numbers(extreme_scene(random)));
    ASSERT_LE(residual_of_solution(lcp), 1e-12) << "V =\n"
                                                << lcp.V << "\np = " << lcp.p.transpose();
  }
}

TEST(solve_lcp, AgreesWithTheClosedFormOfEachCase) {
  Random random(3);
  for (int i = 0; i < 200'000; ++i) {
    const Scene scene = i % 2 ? any_scene(random) : extreme_scene(random);
    ASSERT_LE(disagreement(scene), 1e-9)
        << "scene " << i << ", case " << by_cases(numbers(scene)).mode;
  }
}

TEST(solve_lcp, KeepsTheSmallForceOfAGrazingContact) {
  Random random(10);
  for (int i = 0; i < 10'000; ++i) {
    Numbers n = numbers(any_scene(random));
    n.u_n = -1e-9 * std::abs(n.u_t);
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
    const double f_n = std::max(0.0, -n.u_n / n.a), size = units(form(n)).force;
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
