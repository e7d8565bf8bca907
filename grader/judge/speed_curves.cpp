#include "speed_curves.hpp"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace bounce::judge {
namespace {

using exact::Scene;

constexpr double kDeltaSpeed = 0.1;  // m/s, delta over dt: the assignment's 0.001 m for 0.01 s
constexpr double kNudge = 1e-3;      // m/s and rad/s: a thousandth of typical velocities
constexpr int kFewest = 2, kMost = 15;
constexpr long kStepsInAll = 25'000;  // of all rounds of a point, roughly

// A scene at one dt.
struct Setting {
  const Scene* scene;
  exact::Samples truth;
  Parameters params;
  long steps_between_samples;

  int rounds() const {
    return static_cast<int>(std::clamp<long>(kStepsInAll / params.T, kFewest, kMost));
  }
};

Setting setting_of(const Scene& scene, const exact::Samples& truth, double dt) {
  Setting setting{&scene, truth, scene.params, 0};
  setting.params.dt = exact::fitting_step(scene, dt);
  setting.params.delta = kDeltaSpeed * setting.params.dt;
  setting.steps_between_samples = std::lround(scene.until / exact::kSamples / setting.params.dt);
  setting.params.T = static_cast<int>(exact::kSamples * setting.steps_between_samples) + 1;
  return setting;
}

// The largest distance to the truth over the samples, m.
double error_of(const Setting& setting, const Trajectory& trajectory) {
  exact::Samples samples;
  for (int i = 1; i <= exact::kSamples; ++i) {
    const Eigen::Index column = i * setting.steps_between_samples;
    samples.push_back(
        methods::motion_of<double>({trajectory.q.col(column), trajectory.v.col(column)}));
  }
  return exact::error_of(*setting.scene, samples, setting.truth);
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

// One contender at one setting: what its rounds gave so far. The first is the scene itself, which
// gives the error, and could be known by heart; the others give the time.
struct Tally {
  std::vector<double> ns;
  double error = 0;

  // Runs a round, and returns the time that it took, ns.
  double add(const Setting& setting, Contender& contender, const State& start, int round) {
    const Timed timed = contender.run(setting.params, start);
    if (round == 0) error = error_of(setting, timed.trajectory);
    if (round > 0) ns.push_back(timed.ns);
    return timed.ns;
  }

  // The least time of the rounds, because disturbances only add time.
  Point point(const Setting& setting) const {
    return {setting.params.dt, *std::min_element(ns.begin(), ns.end()) / setting.scene->until,
            error};
  }
};

// Measures one contender.
class Measurement {
 public:
  Measurement(Contender& contender, double budget_ns, std::size_t scenes)
      : contender_(contender), left_ns_(budget_ns) {
    curves_.points.resize(scenes);
  }

  bool goes_on() const { return curves_.cut.empty(); }

  // Decides how many rounds the time allows at this dt: all, the fewest or none.
  void plan(const std::vector<Setting>& settings, double dt) {
    double all = 0, fewest = 0;
    for (const Setting& setting : settings) {
      fewest += ns_per_step_ * setting.params.T * kFewest;
      all += ns_per_step_ * setting.params.T * setting.rounds();
    }
    only_fewest_ = all > left_ns_;
    if (fewest > left_ns_) cut(dt, "it would take more CPU time than there is for all of this");
    ns_ = steps_ = 0;
  }

  // Runs a round, unless the plan has no more for this contender.
  void ask(const Setting& setting, const State& start, int round) {
    if (!goes_on() || (only_fewest_ && round >= kFewest)) return;
    double spent = 0;
    try {
      spent = tally_.add(setting, contender_, start, round);
    } catch (const std::runtime_error& ended) {
      cut(setting.params.dt, ended.what());
      return;
    }
    left_ns_ -= spent;
    ns_ += spent;
    steps_ += setting.params.T;
    ns_per_step_ = ns_ / steps_;
  }

  void finish(const Setting& setting, std::size_t scene) {
    if (goes_on()) curves_.points[scene].push_back(tally_.point(setting));
    tally_ = {};
  }

  const Curves& curves() const { return curves_; }

 private:
  void cut(double dt, const std::string& why) {
    char text[40];
    std::snprintf(text, sizeof text, "at dt = %.2g s: ", dt);
    curves_.cut = text + why;
  }

  Contender& contender_;
  double left_ns_, ns_per_step_ = 0, ns_ = 0, steps_ = 0;
  bool only_fewest_ = false;
  Tally tally_;
  Curves curves_;
};

}  // namespace

std::vector<Scene> scenes_of_one_corner(std::vector<Scene> all) {
  const auto two = [](const Scene& scene) {
    return scene.least == exact::ModelLevel::asleep ||
           scene.least > exact::ModelLevel::one_friction;
  };
  all.erase(std::remove_if(all.begin(), all.end(), two), all.end());
  return all;
}

const std::vector<double>& measured_steps() {
  static const std::vector<double> kSteps{1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5};
  return kSteps;
}

std::vector<Curves> speed_curves(const std::vector<Scene>& scenes,
                                 const std::vector<std::unique_ptr<Contender>>& contenders,
                                 double budget_ns) {
  std::vector<exact::Samples> truths;
  truths.reserve(scenes.size());
  for (const exact::Scene& scene : scenes) truths.push_back(exact::truth_of(scene));
  std::vector<Measurement> measurements;
  measurements.reserve(contenders.size());
  for (const auto& contender : contenders)
    measurements.emplace_back(*contender, budget_ns, scenes.size());
  for (const double dt : measured_steps()) {
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      settings.push_back(setting_of(scenes[i], truths[i], dt));
    for (Measurement& measurement : measurements)
      if (measurement.goes_on()) measurement.plan(settings, dt);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      for (int round = 0; round < settings[i].rounds(); ++round) {
        const State start = round == 0 ? scenes[i].start : nudged(scenes[i].start);
        for (Measurement& measurement : measurements) measurement.ask(settings[i], start, round);
      }
      for (Measurement& measurement : measurements) measurement.finish(settings[i], i);
    }
  }
  std::vector<Curves> all(measurements.size());
  std::transform(measurements.begin(), measurements.end(), all.begin(),
                 [](const Measurement& measurement) { return measurement.curves(); });
  return all;
}

}  // namespace bounce::judge
