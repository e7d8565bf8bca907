// The schemes: what each gets right, and its typical failures.
#include <gtest/gtest.h>

#include <bounce/part3_step.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "common.hpp"
#include "exact/simulate_scene.hpp"
#include "methods/assignment_fast.hpp"
#include "methods/moreau_jean.hpp"
#include "methods/penalty.hpp"
#include "study/catalog.hpp"

namespace bounce::exact::tests {
namespace {

using methods::Assignment;
using methods::AssignmentFast;
using methods::MoreauJean;
using methods::Motion;

const Motion<double> kFlat{0, 0.1, 0, 0, 0, 0};

template <class Scheme>
Motion<double> after(const Parameters& params, const Motion<double>& start, double seconds) {
  Scheme scheme(params, start);
  scheme.steps(std::lround(seconds / params.dt));
  return scheme.motion();
}

Parameters with_dt(double dt) {
  Parameters params;
  params.dt = dt;
  return params;
}

TEST(assignment, IsTheSolutionsStep) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    Drop drop = random_drop(random, i, 0.9);
    State state = methods::state_of(drop.start);
    Assignment scheme(drop.params, drop.start);
    for (int n = 0; n < 100; ++n) {
      state = step(state.q, state.v, drop.params);
      scheme.steps(1);
      const State mine = methods::state_of(scheme.motion());
      ASSERT_LE((mine.q - state.q).norm() + (mine.v - state.v).norm(), 1e-7) << i << " " << n;
      if (n % 10 == 0) scheme = Assignment(drop.params, methods::motion_of<double>(state));
    }
  }
}

TEST(assignment, IsTheSameWithCosineAndSineCarried) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Drop drop = random_drop(random, i, 0.9);
    Assignment plain(drop.params, drop.start);
    AssignmentFast fast(drop.params, drop.start);
    for (int n = 0; n < 40; ++n) {
      plain.steps(1);
      fast.steps(1);
      ASSERT_NEAR(plain.motion().y, fast.motion().y, 1e-7) << i;
      ASSERT_NEAR(plain.motion().theta, fast.motion().theta, 1e-6) << i;
    }
  }
}

// Rounding differs, and impacts of squares that spin fast make more of it.
TEST(assignment, AgreesToRoundingOverAFewStepsWithCosineAndSineCarried) {
  Random random(5);
  int contacts = 0;
  for (int i = 0; i < 500; ++i) {
    const Drop drop = random_drop(random, i, 0.9);
    Assignment plain(drop.params, drop.start);
    for (int n = 0; n < 40; ++n) {
      const Motion<double> before = plain.motion();
      AssignmentFast fast(drop.params, before);
      fast.steps(3);
      plain.steps(3);
      const State one = methods::state_of(plain.motion()), other = methods::state_of(fast.motion());
      contacts += methods::lowest_gap(before, methods::Body<double>(drop.params)) < 0 ? 1 : 0;
      ASSERT_LE((one.q - other.q).norm() / (1 + one.q.norm()), 1e-13) << i << " " << n;
      ASSERT_LE((one.v - other.v).norm() / (1 + one.v.norm()), 1e-12) << i << " " << n;
    }
  }
  EXPECT_GT(contacts, 1000) << "of the starts are in contact";
}

TEST(assignment, CarriedCosinesDoNotDriftInAMillionSteps) {
  Parameters params;
  params.mu = 0;
  const Motion<double> start{0, 0.1, 1e-3, 0.3, 0, 0};
  const Motion<double> plain = after<Assignment>(params, start, 1e4);
  const Motion<double> fast = after<AssignmentFast>(params, start, 1e4);
  const methods::Body<double> body(params);
  EXPECT_NEAR(methods::lowest_gap(plain, body), methods::lowest_gap(fast, body), 0.01);
  EXPECT_NEAR(fast.x, 0.3 * 1e4, 1e-6);
}

TEST(assignment, TouchesInEveryStepOfTheSceneThatTimesContacts) {
  const Scene scene =
      read_scene(std::string(BOUNCE_SCENES) + "/../../solution/study/peers/steps/contact.json");
  Assignment scheme(scene.params, methods::motion_of<double>(scene.start));
  for (long n = 0; n < std::lround(scene.until / scene.params.dt); ++n) {
    const Motion<double> before = scheme.motion();
    EXPECT_LT(methods::lowest_gap(before, methods::Body<double>(scene.params)), scene.params.delta);
    scheme.steps(1);
    const double free = before.v_y + scene.params.dt * scene.params.g.y();
    EXPECT_GT(scheme.motion().v_y, free + 1e-6) << n << ": the ground pushes";
  }
}

TEST(assignment, CarriesNanOnAndEnds) {
  Motion<double> start = kFlat;
  start.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(after<Assignment>(Parameters(), start, 1).y)) << "falls for ever";
  EXPECT_TRUE(std::isnan(after<AssignmentFast>(Parameters(), start, 1).y));
}

TEST(assignment, NeverComesToRestAndASmallerStepDoesNotHelp) {
  for (const double dt : {1e-2, 1e-3, 1e-4}) {
    double highest = 0;
    Assignment scheme(with_dt(dt), kFlat);
    for (int i = 0; i < 1000; ++i) {
      scheme.steps(std::lround(0.01 / dt));
      highest = std::max(highest, scheme.motion().y - 0.1);
    }
    EXPECT_GT(highest, 1.5e-3) << "hovers, dt " << dt;
    EXPECT_GT(std::abs(scheme.motion().x), 5e-3) << "drifts, dt " << dt;
  }
}

TEST(assignment, SinksWithoutDelta) {
  Parameters params;
  params.delta = 0;
  EXPECT_LT(after<Assignment>(params, kFlat, 10).y, 0.1 - 5e-4);
}

TEST(assignment, WithAFixedDeltaOrderOneBecomesAFloor) {
  const Scene slide = scene_named("slide"), drop = scene_named("pointed_drop");
  for (const Scene& scene : {slide, drop}) {
    const Samples truth = truth_of(scene);
    const auto error = [&](std::size_t method, double dt) {
      return error_of(scene, all_methods()[method].run(scene, dt), truth);
    };
    EXPECT_NEAR(error(1, 1e-4) / error(1, 1e-5), 1, 0.1) << scene.name;
    EXPECT_LT(error(2, 1e-5), error(2, 1e-3) / 5) << scene.name << ", delta in proportion to dt";
  }
}

TEST(assignment, PassesThroughTheGround) {
  Parameters params;
  const double rho = params.l / std::sqrt(2.0);
  const Motion<double> fast{0, rho + params.delta + 1e-9, std::numbers::pi / 4, 0, -60, 0};
  Assignment scheme(params, fast);
  scheme.steps(1);
  EXPECT_LT(methods::lowest_gap(scheme.motion(), methods::Body<double>(params)), -0.5);
}

TEST(one_corner, SpinsASquareThatLandsFlat) {
  const Parameters params = with_dt(1e-4);
  const Motion<double> start{0, 0.3, 0, 0, 0, 0};
  EXPECT_GT(std::abs(after<Assignment>(params, start, 0.205).omega), 0.3);
  EXPECT_GT(std::abs(after<MoreauJean<1>>(params, start, 0.205).omega), 0.3);
  EXPECT_EQ(after<MoreauJean<2>>(params, start, 0.205).omega, 0);
}

TEST(one_corner, MirrorsTheOutcomeOfATieAtRounding) {
  Motion<double> left{0, 0.3, 1e-16, 0, 0, 0}, right{0, 0.3, -1e-16, 0, 0, 0};
  const Parameters params = with_dt(1e-4);
  const double one = after<Assignment>(params, left, 0.205).omega;
  const double other = after<Assignment>(params, right, 0.205).omega;
  EXPECT_GT(std::abs(one), 0.3);
  EXPECT_NEAR(one, -other, 1e-6);
  EXPECT_NEAR(after<MoreauJean<2>>(params, left, 0.205).omega, 0, 1e-12);
}

TEST(moreau_jean, StaysAtRestForTenSeconds) {
  for (const double dt : {1e-2, 1e-3}) {
    const Motion<double> s = after<MoreauJean<2>>(with_dt(dt), kFlat, 10);
    EXPECT_EQ(s.x, 0);
    EXPECT_EQ(s.y, 0.1);
    EXPECT_EQ(s.theta, 0);
  }
}

// The square turns about one corner until its neighbour lands; the impact is one of both.
TEST(moreau_jean, SharesALandingWithTheCornerThatIsHeldWhateverTheStep) {
  const Scene scene = scene_named("tilted_settling");
  const Samples truth = truth_of(scene);
  for (int i = 0; i <= 40; ++i) {
    const double dt = 5e-6 * std::pow(10, -i / 50.0);
    EXPECT_LE(error_of(scene, all_methods()[4].run(scene, dt), truth), 3 * dt) << dt;
  }
}

TEST(moreau_jean, LeavesACornerThatLeavesAlone) {
  Motion<double> start = kFlat;
  start.theta = 0.3;
  start.y = 0.12;  // 5 mm below the ground
  start.v_y = 0.02;
  for (const double epsilon : {0.0, 1.0}) {
    Parameters params = with_dt(1e-3);
    params.epsilon = epsilon;
    const double v_y = start.v_y - 1e-3 * 9.81;
    EXPECT_EQ(after<MoreauJean<1>>(params, start, 1e-3).v_y, v_y);
    EXPECT_EQ(after<MoreauJean<2>>(params, start, 1e-3).v_y, v_y);
  }
}

TEST(moreau_jean, GainsNoEnergyInTenThousandDropsBelowTheLimit) {
  Random random(4);
  for (int i = 0; i < 10'000; ++i) {
    Drop drop = random_drop(random, i, 0.7);
    drop.params.dt = 5e-3;
    const methods::Body<double> body(drop.params);
    const double before = methods::energy(drop.start, body);
    const double now = methods::energy(after<MoreauJean<2>>(drop.params, drop.start, 0.5), body);
    ASSERT_LE(now, before + 1e-9 * (1 + std::abs(before))) << i;
  }
}

TEST(penalty, SinksInMoreTheLargerTheStep) {
  const double coarse = 0.1 - after<methods::Penalty>(with_dt(1e-2), kFlat, 5).y;
  const double fine = 0.1 - after<methods::Penalty>(with_dt(1e-3), kFlat, 5).y;
  EXPECT_GT(coarse, 1e-3);
  EXPECT_NEAR(fine, coarse / 10, coarse / 50) << "stiffness grows with 1 / dt";
}

TEST(penalty, DampsAsMuchAsRestitutionSays) {
  for (const double epsilon : {0.14, 0.2, 0.5, 0.8, 0.99}) {
    const double zeta = methods::damping_ratio(epsilon);
    const double left = std::exp(-2 * zeta * std::acos(zeta) / std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(left, epsilon, 1e-12);
  }
  EXPECT_NEAR(methods::damping_ratio(1), 0, 1e-15);
  EXPECT_EQ(methods::damping_ratio(0), 1);
}

// Straight down on the corner beneath the centre, on a face, and on a corner beside the centre:
// v_n of the lowest corner after the impact is epsilon times that before it.
TEST(penalty, BouncesWithNewtonsRestitutionWhereAnImpactHasNoFriction) {
  Parameters params = with_dt(1e-6);
  params.mu = 0;
  for (const double theta : {std::acos(-1.0) / 4, 0.0, 0.3}) {
    methods::Motion<double> s{0, 0, theta, 0, -2, 0};
    const methods::Body<double> body(params);
    const auto corners = methods::arms(body, theta);
    const auto lowest = *std::min_element(corners.begin(), corners.end(),
                                          [](auto& a, auto& b) { return a.y < b.y; });
    s.y = -lowest.y;
    const auto left = after<methods::Penalty>(params, s, 2e-3);
    EXPECT_NEAR(methods::normal_velocity(left, lowest), params.epsilon * 2, 0.05) << theta;
  }
}

TEST(penalty, ComesNearerToStrongesLawThanToNewtonsWhereFrictionTurnsTheSquare) {
  for (const char* name : {"oblique_bounce", "spin", "tumble"}) {
    const Scene scene = scene_named(name);
    const Samples found = all_methods()[5].run(scene, 1e-5);
    EXPECT_GT(error_of(scene, found, truth_of(scene)), 0.02) << name;
    EXPECT_LT(error_of(scene, found, truth_under(methods::ImpactLaw::stronge, scene)),
              error_of(scene, found, truth_of(scene)) / 4)
        << name;
  }
}

}  // namespace
}  // namespace bounce::exact::tests
