#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "../exact/simulate_scene.hpp"
#include "../exact/truth.hpp"
#include "catalog.hpp"
#include "questions.hpp"
#include "random_scenes.hpp"

namespace bounce::study {
namespace {

constexpr double kFine = 1e-3;           // m
constexpr double kChoosing = 1e-3;       // s, of the simulator that chooses, in random scenes
constexpr double kEventsASecond = 5000;  // in random scenes

Motions run_model(const Scene& scene, ModelLevel level, const EventOptions& options = {}) {
  return motion_with(scene, level, even_times(scene.until), options);
}

// In the air or on the ground, turned or flat, with or without friction, spin and a slope: a
// quarter or a third of the scenes has each of what makes a model smaller.
Scene scene_of(unsigned seed) {
  Random random(seed);
  Scene scene{"random", "", {}, {}, random.uniform(0.2, 1), {}};
  Parameters& params = scene.params;
  params.l = random.uniform(0.05, 0.5);
  params.mu = random.one_of(4) ? 0 : random.uniform(0.05, 1);
  params.epsilon = random.one_of(4) ? 0 : random.uniform(0, 0.9);
  const double slope = random.one_of(3) ? random.uniform(-0.4, 0.4) : 0;
  params.g = {9.81 * std::sin(slope), -9.81 * std::cos(slope), 0};
  const bool flat = random.one_of(3), lies = flat && random.one_of(2);
  const double theta = flat ? 0 : random.uniform(-std::numbers::pi, std::numbers::pi);
  const double touching = height_on_ground(params.l / 2, theta);
  scene.start.q = {0, touching + (lies ? 0 : random.uniform(0.01, 2)), theta};
  const double v_x = random.one_of(3) ? 0 : random.uniform(-2, 2);
  scene.start.v = {v_x, lies ? 0 : random.uniform(-2, 2), flat ? 0 : random.uniform(-8, 8)};
  return scene;
}

double error_with(const Scene& scene, ModelLevel level, const Motions& truth) {
  const long most = long(kEventsASecond * scene.until);
  return error_of(scene, run_model(scene, level, {.most_events = most}), truth);
}

// The smallest model that holds every one that simulate_scene took.
ModelLevel chosen_by_bounds(const Scene& scene) {
  ModelReport report{};
  simulate_scene(stepped(scene, kChoosing), scene.start, &report);
  ModelLevel largest = ModelLevel::asleep;
  bool friction = false;
  for (int i = 1; i < kModelLevels; ++i) {
    if (report[std::size_t(i)] == 0) continue;
    largest = ModelLevel(i);
    friction = friction || model_of(largest).friction;
  }
  // Each level contains those before it, except that two corners without friction don't contain
  // one corner with friction.
  return friction && largest == ModelLevel::two_normals ? ModelLevel::two_frictions : largest;
}

}  // namespace

Table least_model(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "model", "error_m", "ns_per_simulated_second", "least", "expected"});
  for (const Scene& scene : scenes) {
    const Motions truth = truth_of(scene);
    std::vector<Job> jobs;
    jobs.reserve(kModelLevels);
    for (int i = 0; i < kModelLevels; ++i)
      jobs.push_back(job_of([&scene, i] { run_model(scene, ModelLevel(i)); }));
    time_in_turn(jobs, extent);
    bool found = false;
    for (int i = 0; i < kModelLevels; ++i) {
      const ModelLevel level = ModelLevel(i);
      const double error = error_of(scene, run_model(scene, level), truth);
      const bool least = !found && error <= kFine;
      found = found || least;
      table.add(scene.name, name_of(level), error, quantile(jobs[std::size_t(i)].ns) / scene.until,
                least, level == scene.least);
    }
  }
  return table;
}

Table chosen_model(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "dt_s", "distance_to_moreau_jean_m", "times_as_fast_as_moreau_jean"});
  // Freed memory stays in this process, so that no time includes the system's allocation of pages,
  // which takes longer than a flight.
  mallopt(M_MMAP_THRESHOLD, 1 << 28);
  mallopt(M_TRIM_THRESHOLD, 1 << 29);
  for (const Scene& scene : scenes) {
    for (const double dt : {1e-2, 1e-3, 1e-4}) {
      const Parameters params = stepped(scene, dt);
      std::vector<Job> jobs{job_of([&] { simulate_scene(params, scene.start); }),
                            job_of([&] { whole_model(params, scene.start); })};
      time_in_turn(jobs, extent);
      table.add(scene.name, dt, distance_to_whole_model(params, scene.start),
                quantile(ratios(jobs[1], jobs[0])));
    }
  }
  return table;
}

// Counts, for each choice and each least model, the scenes; and says how wrong the choice is.
Table random_models(const Scenes&, const Extent&) {
  constexpr unsigned kScenes = 1000;
  struct Count {
    long scenes = 0, wrong = 0;
    double largest_error = 0;
  };
  std::map<std::array<int, 2>, Count> counts;
  for (unsigned seed = 1; seed <= kScenes; ++seed) {
    const Scene scene = scene_of(seed);
    const Motions truth = truth_of(scene);
    const int chosen = int(chosen_by_bounds(scene));
    int least = 0;
    while (least < kModelLevels && !(error_with(scene, ModelLevel(least), truth) <= kFine)) ++least;
    const double error = error_with(scene, ModelLevel(chosen), truth);
    Count& count = counts[{chosen, least}];
    ++count.scenes;
    if (!(error <= kFine)) ++count.wrong;
    count.largest_error = std::max(count.largest_error, error);
  }
  Table table({"chosen", "least", "scenes", "chosen_wrong", "largest_error_m"});
  for (const auto& [key, count] : counts) {
    const char* least = key[1] < kModelLevels ? name_of(ModelLevel(key[1])) : "none";
    table.add(name_of(ModelLevel(key[0])), least, count.scenes, count.wrong, count.largest_error);
  }
  return table;
}

}  // namespace bounce::study
