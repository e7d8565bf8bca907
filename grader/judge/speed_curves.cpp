#include "speed_curves.hpp"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace bounce::judge {
namespace {

constexpr double kDeltaSpeed = 0.1;  // m/s, delta over dt: the assignment's 0.001 m for 0.01 s
constexpr double kNudge = 1e-3;      // m/s and rad/s: a thousandth of typical velocities
constexpr int kFewest = 2, kMost = 5;
constexpr long kStepsInAll = 25'000;  // of all rounds of a point, roughly

// A scene at one dt.
struct Setting {
  const exact::Scene* scene;
  const exact::Samples* truth;
  Parameters params;
  long steps_between_samples;
  int rounds;
};

Setting setting_of(const exact::Scene& scene, const exact::Samples& truth, double dt) {
  Parameters params = scene.params;
  params.dt = exact::fitting_step(scene, dt);
  params.delta = kDeltaSpeed * params.dt;
  const long between = std::lround(scene.until / exact::kSamples / params.dt);
  params.T = static_cast<int>(exact::kSamples * between) + 1;
  const auto rounds = std::clamp<long>(kStepsInAll / params.T, kFewest, kMost);
  return {&scene, &truth, params, between, static_cast<int>(rounds)};
}

// The largest distance to the truth over the samples, m.
double error_of(const Setting& setting, const Trajectory& trajectory) {
  exact::Samples samples;
  for (int i = 1; i <= exact::kSamples; ++i) {
    const Eigen::Index column = i * setting.steps_between_samples;
    samples.push_back(
        methods::motion_of<double>({trajectory.q.col(column), trajectory.v.col(column)}));
  }
  return exact::error_of(*setting.scene, samples, *setting.truth);
}

// The scene's start with random changes to the velocities.
State nudged(State start) {
  std::array<std::uint32_t, 3> random;
  if (::getrandom(random.data(), sizeof random, 0) != sizeof random) {
    throw std::runtime_error("the system gives no random numbers");
  }
  for (std::size_t i = 0; i < 3; ++i) {
    start.v(Eigen::Index(i)) += kNudge * (2.0 * random[i] / UINT32_MAX - 1);
  }
  return start;
}

// Measures one contender.
class Measurement {
 public:
  Measurement(Contender run, double budget_ns, std::size_t scenes)
      : run_(std::move(run)), left_ns_(budget_ns) {
    curves.points.resize(scenes);
  }

  // Runs a round. The first is the scene itself, which could be known by heart. Of the others'
  // times the least counts, because disturbances only add time.
  void ask(const Setting& setting, const State& start, int round) {
    if (!curves.cut && left_ns_ < 0)
      curves.cut = Cut{setting.params.dt, "it takes more CPU time than there is for all of this"};
    if (curves.cut) return;
    try {
      const Timed timed = run_(setting.params, start);
      if (round == 0) error_ = error_of(setting, timed.trajectory);
      least_ns_ = round <= 1 ? timed.ns : std::min(least_ns_, timed.ns);
      left_ns_ -= timed.ns;
    } catch (const Termination& end) {
      curves.cut = Cut{setting.params.dt, "", end};
    } catch (const std::runtime_error& failed) {
      curves.cut = Cut{setting.params.dt, failed.what()};
    }
  }

  void finish(const Setting& setting, std::size_t scene) {
    if (curves.cut) return;
    const double seconds = setting.scene->until;
    curves.points[scene].push_back({setting.params.dt, least_ns_ / seconds, error_});
  }

  Curves curves;

 private:
  Contender run_;
  double left_ns_;
  double least_ns_ = 0, error_ = 0;  // of the rounds at the present setting
};

}  // namespace

std::vector<Curves> speed_curves(const std::vector<exact::Scene>& scenes,
                                 const std::vector<Contender>& contenders, double budget_ns) {
  std::vector<exact::Samples> truths;
  truths.reserve(scenes.size());
  for (const exact::Scene& scene : scenes) truths.push_back(exact::truth_of(scene));
  std::vector<Measurement> measurements;
  measurements.reserve(contenders.size());
  for (const Contender& run : contenders) measurements.emplace_back(run, budget_ns, scenes.size());
  for (const double dt : kMeasuredSteps) {
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      settings.push_back(setting_of(scenes[i], truths[i], dt));
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      for (int round = 0; round < settings[i].rounds; ++round) {
        const State start = round == 0 ? scenes[i].start : nudged(scenes[i].start);
        for (Measurement& measurement : measurements) measurement.ask(settings[i], start, round);
      }
      for (Measurement& measurement : measurements) measurement.finish(settings[i], i);
    }
  }
  std::vector<Curves> all;
  all.reserve(measurements.size());
  for (const Measurement& measurement : measurements) all.push_back(measurement.curves);
  return all;
}

}  // namespace bounce::judge
