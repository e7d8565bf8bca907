#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "../exact/event_driven.hpp"
#include "../exact/simulate_scene.hpp"
#include "../exact/truth.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

constexpr double kFine = 1e-3;  // m
constexpr double kStep = 1e-3;  // s, of the simulator that chooses
constexpr long kEventsASecond = 5000;

// The standard fixes what mt19937_64 gives, but not its distributions.
class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * double(random_() >> 11) * 0x1p-53;
  }
  bool one_of(int n) { return random_() % std::uint64_t(n) == 0; }

 private:
  std::mt19937_64 random_;
};

// In the air or on the ground, turned or flat, with or without friction, spin and a slope: a
// quarter or a third of the scenes has each of what makes a model smaller.
Scene random_scene(unsigned seed) {
  Random random(seed);
  Scene scene{"random", "", {}, {}, Quantity::pose, random.between(0.2, 1), {}, ""};
  Parameters& params = scene.params;
  params.l = random.between(0.05, 0.5);
  params.mu = random.one_of(4) ? 0 : random.between(0.05, 1);
  params.epsilon = random.one_of(4) ? 0 : random.between(0, 0.9);
  const double slope = random.one_of(3) ? random.between(-0.4, 0.4) : 0;
  params.g = {9.81 * std::sin(slope), -9.81 * std::cos(slope), 0};
  const bool flat = random.one_of(3), lies = flat && random.one_of(2);
  const double theta = flat ? 0 : random.between(-std::numbers::pi, std::numbers::pi);
  const double reach = params.l / 2 * (std::abs(std::cos(theta)) + std::abs(std::sin(theta)));
  scene.start.q = {0, reach + (lies ? 0 : random.between(0.01, 2)), theta};
  const double v_x = random.one_of(3) ? 0 : random.between(-2, 2);
  scene.start.v = {v_x, lies ? 0 : random.between(-2, 2), flat ? 0 : random.between(-8, 8)};
  return scene;
}

Model model_of(ModelLevel level) {
  const int corners = level <= ModelLevel::ballistic      ? 0
                      : level <= ModelLevel::one_friction ? 1
                                                          : 2;
  return {corners, level == ModelLevel::one_friction || level == ModelLevel::two_frictions};
}

double error_with(const Scene& scene, ModelLevel level, const Samples& truth) {
  const auto start = methods::motion_of<double>(scene.start);
  if (level == ModelLevel::asleep) return error_of(scene, Samples(kSamples, start), truth);
  EventOptions options;
  options.model = model_of(level);
  options.most_events = long(kEventsASecond * scene.until);
  return error_of(scene, simulate_events<double>(scene.params, start, sample_times(scene), options),
                  truth);
}

// The smallest model that holds every one that simulate_scene took.
ModelLevel chosen_by_bounds(const Scene& scene) {
  Parameters params = scene.params;
  params.dt = kStep;
  params.T = int(std::lround(scene.until / kStep)) + 1;
  ModelReport report;
  simulate_scene(params, scene.start, &report);
  Model all{0, false};
  bool moves = false;
  for (int i = 1; i < kModelLevels; ++i) {
    if (report.steps[std::size_t(i)] == 0) continue;
    moves = true;
    const Model model = model_of(ModelLevel(i));
    all = {std::max(all.corners, model.corners), all.friction || model.friction};
  }
  if (all.corners == 0) return moves ? ModelLevel::ballistic : ModelLevel::asleep;
  if (all.corners == 1) return all.friction ? ModelLevel::one_friction : ModelLevel::one_normal;
  return all.friction ? ModelLevel::two_frictions : ModelLevel::two_normals;
}

}  // namespace

// Counts, for each choice and each least model, the scenes; and says how wrong the choice is.
Table random_models() {
  constexpr unsigned kScenes = 1000;
  struct Count {
    long scenes = 0, wrong = 0;
    double largest_error = 0;
  };
  std::map<std::array<int, 2>, Count> counts;
  for (unsigned seed = 1; seed <= kScenes; ++seed) {
    const Scene scene = random_scene(seed);
    const Samples truth = truth_of(scene);
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
