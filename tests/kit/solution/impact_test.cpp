// The laws of impact, and where they gain energy or have several answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common.hpp"
#include "methods/impact_laws.hpp"
#include "methods/two_corners.hpp"

namespace bounce::exact::tests {
namespace {

using methods::Arm;
using methods::Collision;
using methods::CornerImpulse;
using methods::ImpactLaw;
using methods::Motion;

// The arm of a rectangle of rho 1 and r_g^2 = rho^2 / 3 that leans alpha from the vertical.
methods::OneCorner<double> leaning(double alpha, double u_n, double u_t, double mu) {
  return methods::one_corner<double>({std::sin(alpha), -std::cos(alpha)}, 1.0 / 3, u_n, u_t, mu);
}

Collision<double> collision(double alpha, double v_n, double v_t, double mu, double epsilon) {
  const auto k = leaning(alpha, 0, 0, mu);
  return {k.a, k.b, k.c, v_n, v_t, mu, epsilon};
}

double gain(const Collision<double>& k, ImpactLaw law) {
  return methods::energy_gained(k, methods::impact(k, law));
}

// Kane's paradox: the square of the assignment, thrown onto a corner without gravity.
double energy_ratio_of_kanes_impact(ImpactLaw law) {
  Parameters params;
  params.epsilon = 0.9;
  params.g.setZero();
  const methods::Body<double> body(params);
  Motion<double> s{0, 0.104267, 0.043633, 0.040023, -0.396829, 6.313089};
  const auto all = methods::arms(body, s.theta);
  Arm<double> r = all[0];
  for (const Arm<double>& arm : all)
    if (arm.y < r.y) r = arm;
  const auto k = methods::one_corner<double>(r, body.gyration_squared, 0, 0, body.mu);
  const double before = methods::energy(s, body);
  const auto p = methods::impact<double>({k.a, k.b, k.c, methods::normal_velocity(s, r),
                                          methods::tangential_velocity(s, r), body.mu, 0.9},
                                         law);
  methods::apply_impulse(s, r, p.n, p.t, body.gyration_squared);
  return methods::energy(s, body) / before;
}

TEST(impact, NewtonsLawGainsAQuarterInKanesParadox) {
  EXPECT_NEAR(energy_ratio_of_kanes_impact(ImpactLaw::newton), 1.25, 0.005);
}

TEST(impact, PoissonsAndStrongesLawsDoNot) {
  EXPECT_LT(energy_ratio_of_kanes_impact(ImpactLaw::poisson), 1);
  EXPECT_LT(energy_ratio_of_kanes_impact(ImpactLaw::stronge), 1);
}

TEST(impact, PoissonsAndStrongesLawsNeverGainEnergy) {
  Random random(1);
  for (int i = 0; i < 200'000; ++i) {
    const auto k = collision(random.uniform(-1.5, 1.5), -random.uniform(0.01, 1),
                             random.uniform(-3, 3), random.uniform(0, 1.3), random.uniform(0, 1));
    ASSERT_LE(gain(k, ImpactLaw::poisson), 1e-13) << i;
    ASSERT_LE(gain(k, ImpactLaw::stronge), 1e-13) << i;
  }
}

TEST(impact, NewtonsLawGainsEnergyAboveTheLimitAndNotBelow) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const double alpha = random.uniform(0.05, 1.5), mu = random.uniform(0.01, 1.2);
    const auto k = leaning(alpha, 0, 0, mu);
    const double limit = methods::gain_limit(k.a, k.b, k.c, mu);
    ASSERT_GE(limit, std::sqrt(1 - k.b * k.b / (k.a * k.c)) - 1e-15);
    double above = -1, below = -1;
    for (int j = -2000; j <= 2000; ++j) {
      const double v_t = j / 1000.0;
      above = std::max(above, gain(collision(alpha, -1, v_t, mu, limit + 5e-3), ImpactLaw::newton));
      below = std::max(below, gain(collision(alpha, -1, v_t, mu, limit - 1e-6), ImpactLaw::newton));
    }
    if (limit < 0.99) {
      EXPECT_GT(above, 0) << alpha << " " << mu;
    }
    EXPECT_LE(below, 1e-12) << alpha << " " << mu;
  }
}

TEST(impact, ARectangleNeedsMoreThanFourFifths) {
  double least = 1;
  for (double alpha = 0.01; alpha < 1.57; alpha += 0.001) {
    const auto k = leaning(alpha, 0, 0, 10);
    least = std::min(least, std::sqrt(1 - k.b * k.b / (k.a * k.c)));
  }
  EXPECT_NEAR(least, 0.8, 1e-5);
}

TEST(impact, AllLawsAreOneWithoutFriction) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto k = collision(random.uniform(-1.5, 1.5), -random.uniform(0.1, 1),
                             random.uniform(-3, 3), 0, random.uniform(0, 1));
    const double n = methods::impact(k, ImpactLaw::newton).n;
    EXPECT_NEAR(n, (1 + k.epsilon) / k.a * -k.v_n, 1e-14);
    EXPECT_NEAR(methods::impact(k, ImpactLaw::poisson).n, n, 1e-14);
    EXPECT_NEAR(methods::impact(k, ImpactLaw::stronge).n, n, 1e-13);
  }
}

TEST(impact, KeepsFrictionWithinTheConeAndStopsApproach) {
  Random random(4);
  for (int i = 0; i < 20'000; ++i) {
    const auto k = collision(random.uniform(-1.5, 1.5), -random.uniform(0.1, 1),
                             random.uniform(-3, 3), random.uniform(0, 1.3), random.uniform(0, 1));
    for (const ImpactLaw law : {ImpactLaw::newton, ImpactLaw::poisson, ImpactLaw::stronge}) {
      const CornerImpulse<double> p = methods::impact(k, law);
      ASSERT_LE(std::abs(p.t), k.mu * p.n + 1e-13);
      ASSERT_GE(k.v_n + k.a * p.n + k.b * p.t, -1e-13);
    }
  }
}

TEST(painleve, TheContactProblemMayHaveThreeSolutions) {
  const auto found = methods::all_solutions(leaning(std::atan(0.5), 0.1, 1, 2));
  ASSERT_EQ(found.count, 3);
  std::vector<double> n{found.all[0].n, found.all[1].n, found.all[2].n};
  std::sort(n.begin(), n.end());
  EXPECT_NEAR(n[0], 0, 1e-15);
  EXPECT_NEAR(n[1], 0.125, 1e-12);
  EXPECT_NEAR(n[2], 0.215, 1e-12);
}

TEST(painleve, NeedsMoreThanFourThirdsOfFriction) {
  double least = 10;
  for (double alpha = 0.01; alpha < 1.57; alpha += 0.001) {
    const auto k = leaning(alpha, 0, 0, 0);
    least = std::min(least, k.a / std::abs(k.b));
  }
  EXPECT_NEAR(least, 4.0 / 3, 1e-6);
  const auto worst = leaning(std::atan(0.5), 0, 0, 0);
  EXPECT_NEAR(worst.a / std::abs(worst.b), 4.0 / 3, 1e-12);
}

TEST(painleve, BelowMuStarThereIsAlwaysOneSolutionAndAboveSometimesMore) {
  Random random(5);
  int several = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double alpha = random.uniform(-1.5, 1.5), mu = random.uniform(0, 4);
    const auto k = leaning(alpha, random.uniform(-1, 1), random.uniform(-5, 5), mu);
    const int count = methods::all_solutions(k).count;
    ASSERT_GE(count, 1) << i;
    if (k.a > mu * std::abs(k.b)) {
      ASSERT_EQ(count, 1) << i;
    }
    several += count > 1;
  }
  EXPECT_GT(several, 1000);
}

// A side that lands: both corners, with any of the impulses' laws in one merged problem.
TEST(two_corners, FulfilEveryInequalityOfTheirProblem) {
  Random random(6);
  for (int i = 0; i < 200'000; ++i) {
    const double half = random.uniform(0.05, 1);
    const double theta = i % 3 ? random.uniform(-0.3, 0.3) : random.uniform(-1e-12, 1e-12);
    const auto r = methods::arms(half, std::cos(theta), std::sin(theta));
    const auto k = methods::two_corners<double>(
        r[2], r[3], 4 * half * half / 6, {random.uniform(-2, 1), random.uniform(-2, 1)},
        random.uniform(-3, 3), i % 5 ? random.uniform(0, 1.3) : 0);
    ASSERT_LE(methods::solve_two_corners(k).violation, 1e-13) << i;
  }
}

TEST(two_corners, ShareAFlatLanding) {
  const auto r = methods::arms(0.1, 1.0, 0.0);
  const auto p = methods::solve_two_corners(
      methods::two_corners<double>(r[2], r[3], 0.04 / 6, {-1, -1}, 0, 0.3));
  EXPECT_DOUBLE_EQ(p.n[0], 0.5);
  EXPECT_DOUBLE_EQ(p.n[1], 0.5);
  EXPECT_EQ(p.t, 0);
}

}  // namespace
}  // namespace bounce::exact::tests
