// The simulator that chooses its model: the same as the whole model, faster, and it says how.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "common.hpp"
#include "exact/event_driven.hpp"
#include "exact/simulate_scene.hpp"
#include "study/catalog.hpp"

namespace bounce::exact::tests {
namespace {

double apart(const Parameters& params, const State& start, ModelReport* report = nullptr) {
  return (simulate_scene(params, start, report).q - simulate_whole(params, start).q)
      .cwiseAbs()
      .maxCoeff();
}

long steps(const ModelReport& report, ModelLevel level) { return report.steps[std::size_t(level)]; }

TEST(simulate_scene, IsTheWholeModelInEveryScene) {
  for (Scene scene : scenes()) {
    for (const double dt : {1e-2, 1e-3}) {
      scene.params.dt = dt;
      scene.params.T = int(std::lround(scene.until / dt)) + 1;
      EXPECT_LE(apart(scene.params, scene.start), 1e-6) << scene.name << ", dt " << dt;
    }
  }
}

TEST(simulate_scene, HasTheSchemeOfTheStudyForItsWholeModel) {
  for (Scene scene : scenes()) {
    for (const double dt : {1e-2, 1e-3}) {
      scene.params.dt = dt;
      scene.params.T = int(std::lround(scene.until / dt)) + 1;
      const Trajectory whole = simulate_whole(scene.params, scene.start);
      const Trajectory scheme = simulate_moreau_jean(scene.params, scene.start);
      EXPECT_LE((whole.q - scheme.q).cwiseAbs().maxCoeff(), 1e-9) << scene.name << ", dt " << dt;
    }
  }
}

TEST(simulate_scene, IsTheWholeModelInTenThousandDropsAndFasterThanTheScheme) {
  Random random(1);
  double chosen = 0, scheme = 0;
  for (int i = 0; i < 10'000; ++i) {
    Drop drop = random_drop(random, i, 1);
    drop.params.dt = std::pow(10, random.uniform(-2.7, -1.7));
    drop.params.T = int(1 / drop.params.dt) + 1;
    const State start = methods::state_of(drop.start);
    const double t_0 = cpu_ns();
    const Trajectory one = simulate_scene(drop.params, start);
    const double t_1 = cpu_ns();
    simulate_moreau_jean(drop.params, start);
    chosen += t_1 - t_0;
    scheme += cpu_ns() - t_1;
    const Trajectory whole = simulate_whole(drop.params, start);
    ASSERT_LE((one.q - whole.q).cwiseAbs().maxCoeff(), 1e-6) << i;
  }
  EXPECT_LT(chosen, scheme);
}

// A square that rests in the air between two steps, by less than gravity takes away in one, is held
// all the same, and sleeps.
TEST(simulate_scene, FallsAsleepWithWhateverStep) {
  Scene scene = scene_named("tilted_settling");
  for (const double dt : {1e-2, 3e-3, 1e-3, 3e-4}) {
    scene.params.dt = dt;
    scene.params.T = int(std::lround(scene.until / dt)) + 1;
    ModelReport report;
    simulate_scene(scene.params, scene.start, &report);
    EXPECT_GT(steps(report, ModelLevel::asleep), (scene.params.T - 1) / 2) << dt;
  }
}

TEST(simulate_scene, UsesNoMoreThanTheLeastModelOfAScene) {
  for (Scene scene : scenes()) {
    scene.params.dt = 1e-4;
    scene.params.T = int(std::lround(scene.until / 1e-4)) + 1;
    ModelReport report;
    simulate_scene(scene.params, scene.start, &report);
    for (int level = int(scene.least) + 1; level < kModelLevels; ++level) {
      // The first step of rest is not yet known to be rest; the tumble ends in single corners.
      const long allowed = scene.least == ModelLevel::asleep ? 1 : 0;
      EXPECT_LE(report.steps[std::size_t(level)], allowed)
          << scene.name << name_of(ModelLevel(level));
    }
    EXPECT_EQ(std::accumulate(report.steps.begin(), report.steps.end(), 0L), scene.params.T - 1);
    EXPECT_NEAR(std::accumulate(report.seconds.begin(), report.seconds.end(), 0.0), scene.until,
                1e-9);
  }
}

TEST(simulate_scene, FallsAsleepAndWakesForNothing) {
  const Scene scene = scene_named("tilted_settling");
  Parameters params = scene.params;
  params.dt = 1e-3;
  params.T = 10'001;
  ModelReport report;
  const Trajectory trajectory = simulate_scene(params, scene.start, &report);
  EXPECT_GT(steps(report, ModelLevel::asleep), 9000);
  EXPECT_GT(steps(report, ModelLevel::two_frictions), 0);
  EXPECT_EQ(trajectory.q.col(10'000), trajectory.q.col(5000));
  EXPECT_EQ(trajectory.v.col(10'000), Vector3::Zero());
}

TEST(simulate_scene, DoesNotFallAsleepWhereASquareStopsOnASlope) {
  Parameters params;
  params.g = Vector3(-4, -9, 0);  // steeper than mu 0.3
  params.dt = 1e-3;
  params.T = 1001;
  ModelReport report;
  const State up{{0, 0.1, 0}, {1, 0, 0}};
  const Trajectory trajectory = simulate_scene(params, up, &report);
  EXPECT_EQ(steps(report, ModelLevel::asleep), 0);
  EXPECT_LT(trajectory.v(0, 1000), -0.5) << "it slides back down";
  EXPECT_LE(apart(params, up), 1e-9);
}

TEST(simulate_scene, GoesUpTheLadderWhereABoundIsNotMet) {
  Scene scene = scene_named("oblique_bounce");
  scene.params.dt = 1e-3;
  scene.params.T = 401;
  ModelReport report;
  simulate_scene(scene.params, scene.start, &report);
  EXPECT_EQ(report.raised,
            steps(report, ModelLevel::one_friction) + steps(report, ModelLevel::two_frictions));
  EXPECT_GT(report.raised, 0);
  EXPECT_GT(steps(report, ModelLevel::ballistic), 300);
}

TEST(simulate_scene, WarnsWhereNewtonsLawMayGainEnergy) {
  Scene scene = scene_named("oblique_bounce");
  ModelReport report;
  simulate_scene(scene.params, scene.start, &report);
  EXPECT_TRUE(report.warnings.empty()) << report.warnings[0];
  scene.params.epsilon = 0.99;
  simulate_scene(scene.params, scene.start, &report);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_NE(report.warnings[0].find("epsilon > sqrt(1 - b^2 / (a c))"), std::string::npos);
}

TEST(simulate_scene, WarnsWhereThereMayBeSeveralSolutions) {
  Scene scene = scene_named("tilted_settling");
  scene.params.mu = 3;
  ModelReport report;
  simulate_scene(scene.params, scene.start, &report);
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_NE(report.warnings[0].find("a <= mu |b|"), std::string::npos);
}

TEST(simulate_scene, RefusesWhatItCannotSimulate) {
  const Scene scene = scene_named("rest");
  const auto refusal = [&](auto change) {
    Parameters params = scene.params;
    State start = scene.start;
    change(params, start);
    try {
      simulate_scene(params, start);
    } catch (const std::invalid_argument& problem) {
      return std::string(problem.what());
    }
    return std::string("nothing");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([&](Parameters&, State& s) { s.q.y() = nan; }),
            "q[1] is not finite; write a finite number");
  EXPECT_EQ(refusal([](Parameters& p, State&) { p.mu = -1; }),
            "params.mu is -1; it must be 0 or above");
  EXPECT_EQ(refusal([](Parameters& p, State&) { p.dt = -0.01; }),
            "params.dt is -0.01; it must be above 0");
  EXPECT_EQ(refusal([](Parameters& p, State&) { p.m = 0; }), "params.m is 0; it must be above 0");
}

}  // namespace
}  // namespace bounce::exact::tests
