// The simulator that chooses its model: the same as the whole model.
#include "exact/simulate_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "cases.hpp"
#include "study/catalog.hpp"

namespace bounce::study::tests {
namespace {

ModelReport report_of(const Parameters& params, const State& start) {
  ModelReport report{};
  simulate_scene(params, start, &report);
  return report;
}

long steps(const ModelReport& report, ModelLevel level) { return report[std::size_t(level)]; }

TEST(simulate_scene, IsTheWholeModelInEveryScene) {
  for (const Scene& scene : scenes()) {
    for (const double dt : {1e-2, 1e-3})
      EXPECT_LE(distance_to_whole_model(stepped(scene, dt), scene.start), 1e-6) << scene.name << dt;
  }
}

TEST(simulate_scene, IsTheWholeModelInRandomDrops) {
  Random random(1);
  for (int i = 0; i < random_cases(3000); ++i) {
    Case c = ordinary_case(random, i, 1);
    c.params.dt = std::pow(10, random.uniform(-2.7, -1.7));
    c.params.T = int(1 / c.params.dt) + 1;
    ASSERT_LE(distance_to_whole_model(c.params, state_of(c.start)), 1e-6) << i;
  }
}

TEST(simulate_scene, UsesNoMoreThanTheLeastModelOfAScene) {
  for (const Scene& scene : scenes()) {
    const Parameters params = stepped(scene, 1e-4);
    const ModelReport report = report_of(params, scene.start);
    for (int level = int(scene.least) + 1; level < kModelLevels; ++level) {
      const long allowed = scene.least == ModelLevel::asleep ? 1 : 0;  // not yet known to be rest
      EXPECT_LE(report[std::size_t(level)], allowed) << scene.name << name_of(ModelLevel(level));
    }
    EXPECT_EQ(std::accumulate(report.begin(), report.end(), 0L), params.T - 1);
  }
}

// A square that rests in the air between two steps, by less than gravity takes away in one, is held
// all the same, and sleeps.
TEST(simulate_scene, FallsAsleepWithWhateverStep) {
  const Scene scene = scene_named("tilted_settling");
  for (const double dt : {1e-2, 3e-3, 1e-3, 3e-4}) {
    const Parameters params = stepped(scene, dt);
    ModelReport report{};
    const Trajectory trajectory = simulate_scene(params, scene.start, &report);
    EXPECT_GT(steps(report, ModelLevel::asleep), (params.T - 1) / 2) << dt;
    EXPECT_GT(steps(report, ModelLevel::two_frictions), 0) << dt;
    EXPECT_EQ(trajectory.v.col(params.T - 1), Vector3::Zero());
  }
}

TEST(simulate_scene, DoesNotFallAsleepWhereASquareStopsOnASlope) {
  Parameters params;
  params.g = Vector3(-4, -9, 0);  // steeper than mu 0.3
  params.dt = 1e-3;
  params.T = 1001;
  const State up{{0, 0.1, 0}, {1, 0, 0}};
  EXPECT_EQ(steps(report_of(params, up), ModelLevel::asleep), 0);
  EXPECT_LT(simulate_scene(params, up).v(0, 1000), -0.5) << "it slides back down";
}

}  // namespace
}  // namespace bounce::study::tests
