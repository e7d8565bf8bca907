// A tolerance in, a trajectory out: what is promised of its error, against a second precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/simulate_to.hpp"
#include "study/catalog.hpp"
#include "wide_cases.hpp"

namespace bounce::exact::tests {
namespace {

using methods::Motion;

// In long double, with other tolerances than those that simulate_to works with.
std::vector<Motion<double>> truth(const Scene& scene, const std::vector<double>& times) {
  EventOptions finest;
  finest.cut = 3e-8;
  finest.tolerance = 1e-19;
  finest.touching = 0;
  finest.noise = 0x1p-62;  // for other rounding than that which the bound was measured by
  const auto start = methods::motion_of<long double>(scene.start);
  std::vector<Motion<double>> rounded;
  for (const auto& s : simulate_events<long double>(
           scene.params, start, std::vector<long double>(times.begin(), times.end()), finest)) {
    rounded.push_back(
        {double(s.x), double(s.y), double(s.theta), double(s.v_x), double(s.v_y), double(s.omega)});
  }
  return rounded;
}

double true_error(const Scene& scene, const Answer& answer) {
  const auto exact = truth(scene, answer.times);
  if (exact.size() != answer.times.size()) return INFINITY;
  double worst = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Motion<double>&a = answer.motions[i], &b = exact[i];
    const double turned = scene.params.l / std::sqrt(2.0) * (a.theta - b.theta);
    const double error = std::hypot(a.x - b.x, a.y - b.y, turned);
    worst = error <= worst ? worst : error;
  }
  return worst;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
  return values[values.size() / 2];
}

TEST(simulate_to, KeepsItsBoundInRandomScenes) {
  Random random(21);
  const int count = random_cases(1000) / 2;
  int refused = 0;
  std::vector<double> ratios;
  for (int i = 0; i < count; ++i) {
    const Scene scene = random_scene(random);
    const double tolerance = log_uniform(random, 1e-8, 1e-2);
    try {
      const Answer answer = simulate_to(scene, tolerance);
      ASSERT_EQ(answer.motions.size(), std::size_t(scene.params.T));
      ASSERT_LE(answer.bound, tolerance) << i;
      const double error = true_error(scene, answer);
      ASSERT_LE(error, answer.bound) << i << ", " << answer.method;
      if (error > 0) ratios.push_back(answer.bound / error);
    } catch (const Refusal& refusal) {
      ASSERT_GE(refusal.horizon, 0) << i;
      ASSERT_LT(refusal.horizon, scene.params.dt * (scene.params.T - 1)) << i;
      ++refused;
    }
  }
  std::cout << refused << " of " << count << " refused; bound over error " << median(ratios)
            << "\n";
  EXPECT_LT(refused, count / 2);
  EXPECT_LE(median(ratios), 100);
}

// The least CPU time of five runs, ns.
template <class Run>
double least_time(const Run& run) {
  double least = INFINITY;
  for (int i = 0; i < 5; ++i) {
    const double begin = study::cpu_ns();
    run();
    least = std::min(least, study::cpu_ns() - begin);
  }
  return least;
}

// The study has it at less than half as much again; this holds on machines that do other work, too.
TEST(simulate_to, TakesAtMostTwiceAsLongAsEventsAloneInTheMedian) {
  Random random(23);
  std::vector<double> ratios;
  for (int i = 0; i < 500; ++i) {
    const Scene scene = random_scene(random);
    const auto start = methods::motion_of<double>(scene.start);
    try {
      const std::vector<double> times = simulate_to(scene, 1e-6).times;
      const double events =
          least_time([&] { simulate_events<double>(scene.params, start, times, {}); });
      ratios.push_back(least_time([&] { simulate_to(scene, 1e-6); }) / events);
    } catch (const Refusal&) {
    }
  }
  EXPECT_LE(median(ratios), 2);
}

TEST(simulate_to, StepsWhereThereAreTooManyEvents) {
  Random random(22);
  int stepped = 0;
  for (int i = 0; i < 20; ++i) {
    Scene scene = crowded_scene(random);
    scene.params.T = 10;
    try {
      const Answer answer = simulate_to(scene, 1e-3);
      stepped += answer.step > 0;
      ASSERT_LE(true_error(scene, answer), answer.bound) << i << ", " << answer.method;
    } catch (const Refusal&) {
    }
  }
  EXPECT_GT(stepped, 0);
}

Scene drop() {
  Scene scene{};
  scene.start.q = Vector3(0, 0.3, 0.3);
  scene.params.T = 10;
  return scene;
}

TEST(simulate_to, TakesTheClosedFormUntilTheFirstImpact) {
  EXPECT_EQ(simulate_to(drop(), 1e-6).method, "free flight");
}

TEST(simulate_to, FollowsAFlatDropAndRestExactly) {
  Scene scene = drop();
  scene.start.q(2) = 0;
  scene.params.T = 300;
  const Answer answer = simulate_to(scene, 1e-9);
  EXPECT_EQ(answer.motions.back().y, scene.params.l / 2);
  EXPECT_LE(true_error(scene, answer), answer.bound);
}

// On a corner that rounding puts 5e-17 l above the ground, it slides so fast that friction in the
// fall through this gap shows: the bound takes in both readings of the start, or there is no
// answer.
TEST(simulate_to, KeepsItsBoundWhereRoundingDecidesWhetherTheStartTouches) {
  Random random(41);
  for (int i = 0; i < random_cases(1000) / 5; ++i) {
    const WideCase c = wide_case(random, i);
    Scene scene{};
    scene.params = c.params;
    scene.params.T = 21;
    scene.params.dt = c.until / 20;
    scene.start = methods::state_of(c.start);
    try {
      const Answer answer = simulate_to(scene, 1e-3 * c.params.l);
      ASSERT_LE(true_error(scene, answer), answer.bound) << i;
    } catch (const Refusal&) {
    }
  }
}

// --- perturbed motions ---

constexpr double kNoise = 0x1p-40;

// How far apart the perturbed motions of four seeds come, m; 0 where they are lost.
double perturbed_apart(const Scene& scene, const std::vector<double>& times) {
  double apart = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    EventOptions options;
    options.perturbation = kNoise;
    options.seed = seed;
    EventReport report;
    simulate_events<double>(scene.params, methods::motion_of<double>(scene.start), times, options,
                            &report);
    if (report.perturbed_distances.size() < times.size()) return 0;
    apart = std::max(apart, report.perturbed_distances.back());
  }
  return apart;
}

// How far shadows of eight seeds come from the motion, m.
double shadows_apart(const Scene& scene, const std::vector<double>& times) {
  const auto start = methods::motion_of<double>(scene.start);
  const auto motions = simulate_events<double>(scene.params, start, times, {});
  double apart = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    EventOptions options;
    options.noise = kNoise;
    options.seed = seed;
    const auto shadow = simulate_events<double>(scene.params, start, times, options);
    apart = std::max(apart, error_of(scene, shadow, motions));
  }
  return apart;
}

// Or farther: each of their impacts is late, and rounding's are so by chance.
TEST(perturbed_motions, ComeAtLeastAsFarApartAsShadowsDo) {
  Random random(24);
  std::vector<double> ratios;
  for (int i = 0; i < 500; ++i) {
    Scene scene = random_scene(random);
    scene.start.q(1) += 0.1 * scene.params.l;
    const auto times = even_times(scene.params.dt * scene.params.T, 20);
    const double perturbed = perturbed_apart(scene, times);
    if (perturbed > 0) ratios.push_back(perturbed / shadows_apart(scene, times));
  }
  ASSERT_GT(ratios.size(), 100U);
  EXPECT_GT(*std::min_element(ratios.begin(), ratios.end()), 0.3);
  EXPECT_LT(median(ratios), 10);
}

TEST(perturbed_motions, AreLostWhereASideLands) {
  Scene scene = drop();
  scene.start.q(2) = 0;
  EXPECT_EQ(perturbed_apart(scene, even_times(1.0, 10)), 0);
}

// Balanced on a corner, as far as doubles say: rounding decides when it falls.
TEST(simulate_to, RefusesWhatRoundingDecides) {
  Scene scene = drop();
  const double theta = std::atan(1.0);
  scene.start.q = Vector3(0, scene.params.l * std::sqrt(0.5) * (1 + 1e-15), theta);
  scene.params.mu = 1;
  scene.params.T = 1000;
  try {
    simulate_to(scene, 1e-3);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_GT(refusal.horizon, 0.3);
    EXPECT_LT(refusal.horizon, 5);
    EXPECT_EQ(std::string(refusal.what()).find('\n'), std::string::npos);
  }
}

TEST(simulate_to, RefusesAToleranceBelowRounding) {
  EXPECT_THROW(simulate_to(drop(), 1e-20), Refusal);
  for (const double tolerance : {0.0, -1.0, std::nan(""), double(INFINITY)})
    EXPECT_THROW(simulate_to(drop(), tolerance), std::invalid_argument);
}

}  // namespace
}  // namespace bounce::exact::tests
