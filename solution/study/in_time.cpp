// Where methods fail that look right in a single impact: at rest, on a slope, over ten seconds, in
// how high the square bounces, and with much friction; and where event-driven simulation fails.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "../exact/truth.hpp"
#include "../methods/impact_laws.hpp"
#include "catalog.hpp"
#include "peers/engine.hpp"
#include "questions.hpp"
#include "random_scenes.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

const std::vector<double> kSteps{1e-2, 3e-3, 1e-3, 3e-4, 1e-4};

const std::vector<double>& settings_of(const Method& method) {
  return method.has_step ? kSteps : method.settings;
}

const Scene& scene_of(const Scenes& scenes, const std::string& name) {
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const Scene& scene) { return scene.name == name; });
  if (found == scenes.end()) throw std::invalid_argument("there is no scene " + name);
  return *found;
}

// Half a second after it was at rest on a slope: on one that holds it, it is still there; on a
// steeper one it slides.
double off_on_slope(const Method& method, Scene scene, double tilt, double setting) {
  const double g = scene.params.g.norm(), pull = std::sin(tilt), mu = scene.params.mu;
  scene.params.g = g * Vector3(pull, -std::cos(tilt), 0);
  scene.until = 0.5;
  const double a = g * std::max(0.0, pull - mu * std::cos(tilt));
  Motion<double> exact = motion_of(scene.start);
  exact.x += a * scene.until * scene.until / 2;
  const Motions motions = method.simulate(scene, setting, 1);
  return motions.empty() ? NAN : distance(scene, motions.back(), exact);
}

// Tumbles for ever: no friction, no loss.
Scene lossless(const Scene& rest, double until) {
  Scene scene = rest;
  scene.params.mu = 0;
  scene.params.epsilon = 1;
  scene.start = {{0, 5 * scene.params.l, 0.3}, {0, 0, 5}};
  scene.until = until;
  return scene;
}

// The largest change of energy, as a share, in ten seconds of tumbling without a loss. Near the
// ground it may be in a spring.
double energy_gained_by(const Method& method, const Scene& scene, double setting) {
  constexpr int kLooks = 100;
  const auto energy = [&](const Motion<double>& s) {
    const double l = scene.params.l;
    return (s.v_x * s.v_x + s.v_y * s.v_y + l * l / 6 * s.omega * s.omega) / 2 -
           scene.params.g(1) * s.y;
  };
  const double before = energy(motion_of(scene.start));
  double most = 0;
  for (const Motion<double>& s : method.simulate(scene, setting, kLooks)) {
    const bool flies = lowest_gap(s, Body<double>(scene.params)) > scene.params.l / 100;
    if (flies) most = std::max(most, std::abs(energy(s) / before - 1));
  }
  return most;
}

// The median over starts that differ by less than is seen: after half of the time rounding decides.
double typical_gain(const Method& method, Scene scene, double setting) {
  constexpr int kNeighbours = 15;
  std::vector<double> gains;
  for (int i = 0; i < kNeighbours; ++i) {
    scene.start.q(2) = 0.3 + 1e-12 * i;
    gains.push_back(energy_gained_by(method, scene, setting));
  }
  return quantile(gains);
}

struct Range {
  double least = 1e300, most = -1e300;
};

// The restitution that a method really gives a square that falls on a face (theta = 0) or a corner:
// the root of the height that it will reach over that from which it fell, read in flight. A range
// over heights that are parts of a step's fall apart, as much depends on where in a step it lands.
Range restitution_of(const Method& method, Scene scene, double epsilon, double theta, double dt) {
  constexpr int kHeights = 16;
  scene.params.mu = 0;
  scene.params.epsilon = epsilon;
  const double g = scene.params.g.norm();
  const double lying = height_on_ground(scene.params.l / 2, theta);
  Range range;
  for (int i = 0; i < kHeights; ++i) {
    const double falls = std::sqrt(2 * 0.2 / g) + (method.has_step ? dt * i / kHeights : 0);
    const double height = g * falls * falls / 2;
    scene.start = {{0, lying + height, theta}, {0, 0, 0}};
    scene.until = falls * (1 + epsilon);  // it is in the middle of its second flight
    const Motions motions = method.simulate(scene, dt, 1);
    if (motions.empty()) return {NAN, NAN};
    const Motion<double>& s = motions.back();
    const double reaches = s.y - lying + s.v_y * s.v_y / (2 * g);
    const double found = std::sqrt(std::max(0.0, reaches / height));
    range = {std::min(range.least, found), std::max(range.most, found)};
  }
  return range;
}

// A square that comes down on a corner within a tenth of a second, and bounces for another two.
Scene random_throw(Random& random, double mu) {
  Scene scene{};
  scene.params.mu = mu;
  const double theta = random.uniform(-4, 4), l = scene.params.l;
  const auto height = height_on_ground(l / 2, theta) + l * random.uniform(0.01, 0.5);
  scene.start = {{0, height, theta},
                 {random.uniform(-3, 3), random.uniform(-2, 0), random.uniform(-10, 10)}};
  scene.until = 0.3;
  return scene;
}

// How far the event-driven method in double is from the truth at scene.until.
double off_by_rounding(const Scene& scene, EventReport* report = nullptr) {
  const auto motions =
      simulate_events<double>(scene.params, motion_of(scene.start), {scene.until}, {}, report);
  return motions.empty() ? NAN : distance(scene, motions[0], truth_of(scene, 1)[0]);
}

// Balances on a corner, but for an angle; until it would have fallen by half a radian if it went on
// as it began: a small angle grows by exp(rate t), with rate^2 = g rho / (l^2/6 + rho^2).
Scene balanced(const Scene& rest, double angle) {
  Scene scene = rest;
  const double l = scene.params.l, rho = l / std::numbers::sqrt2,
               theta = std::numbers::pi / 4 + angle;
  const double rate = std::sqrt(scene.params.g.norm() * rho / (l * l / 6 + rho * rho));
  scene.params.mu = 5;
  scene.start = {{0, height_on_ground(l / 2, theta), theta}, {0, 0, 0}};
  scene.until = std::acosh(0.5 / (theta - std::numbers::pi / 4)) / rate;
  return scene;
}

// Falls on a face and bounces until it lies.
Scene bouncing(const Scene& rest, double epsilon) {
  Scene scene = rest;
  scene.params.mu = 0;
  scene.params.epsilon = epsilon;
  scene.start.q(1) += 0.1;
  const double falls = std::sqrt(2 * 0.1 / scene.params.g.norm());
  scene.until = 1.01 * falls * (1 + epsilon) / (1 - epsilon);
  return scene;
}

}  // namespace

Table rest_and_drift(const Scenes& scenes, const Extent&) {
  Table table({"method", "setting", "height_m", "depth_m", "drift_m"});
  Scene scene = scene_of(scenes, "rest");
  scene.until = 10;
  std::vector<Method> all = all_methods();
  Method sinking = all.front();
  sinking.name = "assignment_delta_0";
  sinking.simulate = [simulate = sinking.simulate](Scene without, double dt, int samples) {
    without.params.delta = 0;
    return simulate(without, dt, samples);
  };
  all.push_back(sinking);
  for (const Method& method : all) {
    for (const double setting : settings_of(method)) {
      double height = 0, depth = 0, drift = 0;
      const int looks = method.has_step ? int(std::lround(scene.until / setting)) : 10'000;
      for (const Motion<double>& s : method.simulate(scene, setting, looks)) {
        height = std::max(height, s.y - scene.start.q(1));
        depth = std::max(depth, scene.start.q(1) - s.y);
        drift = std::max(drift, std::abs(s.x - scene.start.q(0)));
      }
      table.add(method.name, setting, height, depth, drift);
    }
  }
  return table;
}

Table slope_and_energy(const Scenes& scenes, const Extent&) {
  Table table({"case", "tilt_rad", "method", "setting", "off"});
  const Scene& rest = scene_of(scenes, "rest");
  for (const Method& method : all_methods()) {
    for (const double setting : settings_of(method)) {
      for (const double tilt : {0.1, 0.2, 0.4})
        table.add("slope", tilt, method.name, setting, off_on_slope(method, rest, tilt, setting));
      table.add("energy", 0.0, method.name, setting,
                typical_gain(method, lossless(rest, 10), setting));
    }
  }
  return table;
}

Table restitution(const Scenes& scenes, const Extent&) {
  Table table({"lands_on", "epsilon", "method", "setting", "least", "most"});
  Methods methods = all_methods();
  for (const auto& [name, peer] : all_peers) methods.push_back(method_of(name, peer, 1e-4));
  for (const Method& method : methods) {
    for (const double setting : settings_of(method)) {
      for (const double epsilon : {0.5, 1.0}) {
        for (const bool face : {true, false}) {
          const double theta = face ? 0 : std::numbers::pi / 4;
          const Range r = restitution_of(method, scene_of(scenes, "rest"), epsilon, theta, setting);
          table.add(face ? "face" : "corner", epsilon, method.name, setting, r.least, r.most);
        }
      }
    }
  }
  return table;
}

Table large_friction(const Scenes&, const Extent&) {
  constexpr int kThrows = 400;
  Table table({"mu", "method", "dt_s", "throws", "off_by_more_than_1_mm", "largest_m"});
  for (const double mu : {0.3, 0.6, 1.0, 1.3, 1.4, 2.0, 5.0}) {
    for (const Method& method : all_methods()) {
      if (method.name != "assignment_delta_dt" && method.name != "moreau_jean_2") continue;
      for (const double dt : {1e-3, 1e-4, 1e-5}) {
        Random random(7);
        int off = 0;
        double largest = 0;
        for (int i = 0; i < kThrows; ++i) {
          const Scene scene = random_throw(random, mu);
          const double error = error_of(scene, method.simulate(scene, dt, 1), truth_of(scene, 1));
          off += error > 1e-3;
          largest = std::max(largest, error);
        }
        table.add(mu, method.name, dt, kThrows, off, largest);
      }
    }
  }
  return table;
}

Table event_limits(const Scenes& scenes, const Extent&) {
  const Scene& rest = scene_of(scenes, "rest");
  Table table({"case", "value", "until_s", "impacts", "off_m"});
  const auto add = [&](const char* name, double value, const Scene& scene) {
    EventReport report;
    const double off = off_by_rounding(scene, &report);
    table.add(name, value, scene.until, report.impacts, off);
  };
  for (const double epsilon : {0.5, 0.9, 0.99, 0.999, 0.9999})
    add("epsilon", epsilon, bouncing(rest, epsilon));
  for (int t = 1; t <= 20; ++t) add("tumbling", t, lossless(rest, t));
  for (int k = 1; k <= 15; ++k)
    add("balance", std::pow(10.0, -k), balanced(rest, std::pow(10.0, -k)));
  return table;
}

}  // namespace bounce::study
