// A tolerance in, a trajectory out: what is promised of its error, against a second precision.
#include "exact/simulate_to.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cases.hpp"
#include "exact/truth.hpp"

namespace bounce::study::tests {
namespace {

double true_error(const Scene& scene, const Answer& answer) {
  return error_of(scene, answer.motions, second_truth(scene, answer.times));
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// A square that hops too often for its hops to be followed one by one.
Scene crowded_scene(Random& random) {
  Scene scene = random_scene(random);
  scene.params.epsilon = chance(random, 0.5) ? 1 : 1 - log_uniform(random, 1e-6, 1e-3);
  scene.params.g = Vector3(0, -9.81, 0);
  scene.params.T = 40;
  const double l = scene.params.l;
  scene.start.q = Vector3(0, l / 2 + l * log_uniform(random, 1e-10, 1e-6), 0);
  scene.start.v = Vector3(random.uniform(-1, 1), 0, 0);
  return scene;
}

// On a corner that rounding puts 5e-17 l above the ground, a square may slide so fast that friction
// in the fall through this gap shows: the bound takes in both readings of the start, or there is no
// answer.
Scene scene_at_any_scale(Random& random) {
  const Case c = wide_case(random, 0);
  Scene scene{};
  scene.params = c.params;
  scene.params.T = 21;
  scene.params.dt = c.until / 20;
  scene.start = state_of(c.start);
  return scene;
}

struct SceneKind {
  const char* name;
  Scene (*make)(Random&);
  int share;      // one case of so many; 0: a few, which take long
  bool answered;  // most of them are, with a bound near the error
};

TEST(simulate_to, KeepsItsBoundOrRefuses) {
  for (const SceneKind& kind : {SceneKind{"ordinary", random_scene, 2, true},
                                SceneKind{"touching by rounding", scene_at_any_scale, 5, false},
                                SceneKind{"crowded", crowded_scene, 0, false}}) {
    Random random(kind.answered ? 21 : 41);
    const int count = kind.share > 0 ? random_cases(1000) / kind.share : 20;
    int refused = 0;
    std::vector<double> ratios;
    for (int i = 0; i < count; ++i) {
      const Scene scene = kind.make(random);
      const double tolerance =
          kind.answered ? log_uniform(random, 1e-8, 1e-2) : 1e-3 * scene.params.l;
      try {
        const Answer answer = simulate_to(scene, tolerance);
        ASSERT_EQ(answer.motions.size(), std::size_t(scene.params.T));
        ASSERT_LE(answer.bound, tolerance) << kind.name << i;
        const double error = true_error(scene, answer);
        ASSERT_LE(error, answer.bound) << kind.name << i;
        if (error > 0) ratios.push_back(answer.bound / error);
      } catch (const Refusal& refusal) {
        ASSERT_GE(refusal.horizon, 0) << kind.name << i;
        ASSERT_LT(refusal.horizon, scene.params.dt * (scene.params.T - 1)) << kind.name << i;
        ++refused;
      }
    }
    if (kind.answered) {
      EXPECT_LT(refused, count / 2);
      EXPECT_LE(median(ratios), 10);
    }
  }
}

// It begins with 2441 turns: their product with 2 pi rounds more than long double does otherwise.
TEST(simulate_to, KeepsItsBoundAfterManyTurns) {
  Random random(21);
  Scene scene{};
  for (int i = 0; i <= 342; ++i) scene = scene_at_any_scale(random);
  const Answer answer = simulate_to(scene, 1e-3 * scene.params.l);
  EXPECT_LE(true_error(scene, answer), answer.bound);
}

Scene drop(double theta, int T) {
  Scene scene{};
  scene.start = {{0, 0.3, theta}, {0, 0, 0}};
  scene.params.T = T;
  return scene;
}

TEST(simulate_to, FollowsAFlatDropAndRestExactly) {
  const Scene scene = drop(0, 300);
  const Answer answer = simulate_to(scene, 1e-9);
  EXPECT_EQ(answer.motions.back().y, scene.params.l / 2);
  EXPECT_LE(true_error(scene, answer), answer.bound);
}

// Balanced on a corner, as far as doubles say: rounding decides when it falls.
TEST(simulate_to, RefusesWhatRoundingDecides) {
  Scene scene = drop(std::atan(1.0), 1000);
  scene.start.q.y() = scene.params.l * std::sqrt(0.5) * (1 + 1e-15);
  scene.params.mu = 1;
  try {
    simulate_to(scene, 1e-3);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_GT(refusal.horizon, 0.3);
    EXPECT_LT(refusal.horizon, 5);
  }
}

TEST(simulate_to, RefusesAToleranceBelowRounding) {
  EXPECT_THROW(simulate_to(drop(0.3, 10), 1e-20), Refusal);
}

}  // namespace
}  // namespace bounce::study::tests
