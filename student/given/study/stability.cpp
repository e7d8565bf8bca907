#include <algorithm>
#include <bounce/part3_step.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure.hpp"
#include "page.hpp"

namespace bounce::study {
namespace {

constexpr double kCoarse = 1e-2, kFine = 1e-3;  // s
constexpr double kRestSeconds = 10, kSlopeSeconds = 1, kLongSeconds = 100;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = std::numbers::pi / 180;

// A trial with the lines of its chart. What was found in it is said, unless the program gave no
// number.
json trial(const char* name, double found, const std::string& sentence, const json& lines) {
  const char* none = "NaN, or another number of columns: ./check says where";
  return {{"name", name}, {"found", std::isnan(found) ? none : sentence}, {"lines", lines}};
}

// What `measure` gives at each x, in a line for each step.
template <class Measure>
json with_both_steps(const std::vector<double>& at, const Measure& measure) {
  json lines;
  for (const double dt : {kCoarse, kFine}) {
    Points points;
    for (const double x : at) points.emplace_back(x, measure(x, dt));
    lines.push_back(line("dt = " + number(dt) + " s", points));
  }
  return lines;
}

double deepest(const Trajectory& moved, double l) {
  double most = 0;
  for (const auto& q : moved.q.colwise()) most = std::max(most, -lowest_heights(q, l)[0]);
  return most;
}

// ---- large epsilon with friction ----

// The most that one impact adds to the energy, as a share of what the corner's motion had, over
// landings in every direction on a corner; without gravity, so that the lift adds nothing.
double largest_gain(Parameters params, double epsilon, double mu) {
  params.g.setZero();
  params.epsilon = epsilon;
  params.mu = mu;
  const double arm = params.l / std::numbers::sqrt2;
  const auto energy = [&](const Vector3& v) { return v.dot(params.M() * v) / 2; };
  double largest = -1;
  for (int lean = -15; lean <= 15; ++lean) {
    const double a = lean * 3 * kDegree * 0.97;
    const double r_x = arm * std::sin(a), r_y = -arm * std::cos(a);
    Jacobian J;
    J << 1, 0, 0, 1, -r_y, r_x;
    // The motion v = M^-1 J f in which the corner moves by u = J^T v, and nothing else moves.
    const Jacobian of_force = params.M().inverse() * J;
    const Jacobian of_corner = of_force * (J.transpose() * of_force).inverse();
    const Vector3 q(0, -r_y + params.delta / 2, std::numbers::pi / 4 + a);
    for (int from = -88; from <= 88; from += 2) {
      const Vector3 v =
          of_corner * Eigen::Vector2d(std::sin(from * kDegree), -std::cos(from * kDegree));
      const double gain = energy(step(q, v, params).v) / energy(v) - 1;
      if (!std::isfinite(gain)) return kNone;
      largest = std::max(largest, gain);
    }
  }
  return largest;
}

json impact(const Parameters& params) {
  double first = 2, most = 0;
  json lines;
  for (const double mu : {0.1, 0.3, 1.0}) {
    Points points;
    for (int i = 0; i <= 100; i += i < 70 ? 10 : 1) {
      const double epsilon = i / 100.0, gain = largest_gain(params, epsilon, mu);
      points.emplace_back(epsilon, 100 * gain);
      if (gain > 1e-9) first = std::min(first, epsilon);
      most = std::isnan(gain) ? kNone : std::max(most, gain);
    }
    lines.push_back(line("mu = " + number(mu), points));
  }
  lines.push_back(line("no gain", {{0, 0}, {1, 0}}, "bound"));
  const std::string found = first > 1 ? "no impact gains energy"
                                      : "from epsilon = " + number(first) +
                                            " on some impacts gain energy, up to " +
                                            number(100 * most, "%.2g") + " %";
  return trial("impact", most, found, lines);
}

// ---- fast fall ----

// How deep a corner gets that comes down at this speed, over eight moments in a step at which it
// reaches the ground.
double depth(const Parameters& params, double speed, double dt) {
  double most = 0;
  for (int k = 0; k < 8; ++k) {
    const double y = params.l / std::numbers::sqrt2 + params.delta + speed * dt * k / 8;
    const auto moved = motion({{0, y, 45 * kDegree}, {0, -speed, 0}}, params, dt, 4 * dt);
    if (!moved) return kNone;
    most = std::max(most, deepest(*moved, params.l));
  }
  return most;
}

json fall(const Parameters& params) {
  const std::vector<double> speeds{1, 2, 5, 10, 20, 60, 100};
  json lines =
      with_both_steps(speeds, [&](double speed, double dt) { return depth(params, speed, dt); });
  for (const double dt : {kCoarse, kFine}) {
    lines.push_back(line("v dt, dt = " + number(dt) + " s", {{1, dt}, {100, 100 * dt}}, "bound"));
  }
  const double at_60 = depth(params, 60, kCoarse);
  return trial("fall", at_60,
               "at 60 m/s it sinks in by " + length(at_60, "%.2g") + ", " +
                   number(at_60 / params.l, "%.2g") + " sides, with dt = 0.01 s",
               lines);
}

// ---- rest ----

// How far a square that lies on its face gets in ten seconds, m.
struct Rest {
  double up = kNone, along = kNone, below = kNone;
};

Rest rest(Parameters params, double dt, double delta) {
  params.delta = delta;
  const auto moved = motion({{0, params.l / 2, 0}, Vector3::Zero()}, params, dt, kRestSeconds);
  if (!moved) return {};
  return {std::max(0.0, moved->q.row(1).maxCoeff() - params.l / 2),
          moved->q.row(0).cwiseAbs().maxCoeff(), deepest(*moved, params.l)};
}

json tremble(const Parameters& params) {
  json lines;
  for (const bool scaled : {false, true}) {
    Points up, along;
    for (const double dt : {2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4}) {
      const Rest far = rest(params, dt, scaled ? kShare * dt : params.delta);
      up.emplace_back(dt, far.up);
      along.emplace_back(dt, far.along);
    }
    const std::string with = scaled ? "delta = 0.1 m/s dt" : "delta fixed";
    lines.push_back(line("up, " + with, up));
    lines.push_back(line("along, " + with, along));
  }
  const Rest usual = rest(params, kCoarse, params.delta);
  return trial("rest", usual.up,
               "it trembles, up to " + length(usual.up, "%.2g") +
                   " above where it should lie, and wanders by " + length(usual.along, "%.2g") +
                   " in ten seconds, with dt = 0.01 s",
               lines);
}

// ---- tilted ground ----

Vector3 tilted(double degrees) {
  return 9.81 * Vector3(std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0);
}

double way_down(Parameters params, double degrees, double dt) {
  params.g = tilted(degrees);
  const auto moved = motion({{0, params.l / 2, 0}, Vector3::Zero()}, params, dt, kSlopeSeconds);
  return moved ? moved->q(0, moved->q.cols() - 1) : kNone;
}

json slope(const Parameters& params) {
  std::vector<double> tilts;
  Points right;
  for (int tilt = 0; tilt <= 30; tilt += 2) {
    const Vector3 g = tilted(tilt);
    tilts.push_back(tilt);
    right.emplace_back(
        tilt, std::max(0.0, 0.5 * (g(0) + params.mu * g(1)) * kSlopeSeconds * kSlopeSeconds));
  }
  json lines = with_both_steps(
      tilts, [&](double degrees, double dt) { return way_down(params, degrees, dt); });
  lines.push_back(line("right", right, "bound"));
  const double at_10 = way_down(params, 10, kFine);
  return trial("slope", at_10,
               "on 10 degrees it creeps " + length(std::abs(at_10), "%.2g") +
                   " in a second, with dt = 0.001 s",
               lines);
}

// ---- thin contact ----

json thin(const Parameters& params) {
  std::vector<double> deltas;
  for (double delta = 1e-2; delta > 5e-7; delta /= std::sqrt(10)) deltas.push_back(delta);
  const auto below = [&](double delta, double dt) { return rest(params, dt, delta).below; };
  const double at_least = below(1e-6, kCoarse);
  return trial("thin", at_least,
               "with delta = 1 \xc2\xb5m it sinks in by " + length(at_least, "%.2g") +
                   ", and stays there, with dt = 0.01 s",
               with_both_steps(deltas, below));
}

// ---- long run ----

json long_run(Parameters params) {
  params.epsilon = 1;
  params.mu = 0;
  const State start{{0, 0.5, 0.3}, {1, 0, 5}};
  const auto energy = [&](const Vector3& q, const Vector3& v) {
    return 0.5 * v.dot(params.M() * v) - params.m * params.g.dot(q);
  };
  json lines;
  double last = kNone;
  for (const double dt : {kCoarse, kFine}) {
    Points points;
    last = kNone;
    const auto moved = motion(start, params, dt, kLongSeconds);
    for (int i = 0; moved && i <= 100; ++i) {
      const Eigen::Index t = (moved->q.cols() - 1) * i / 100;
      last = energy(moved->q.col(t), moved->v.col(t)) / energy(start.q, start.v);
      points.emplace_back(static_cast<double>(t) * dt, last);
    }
    lines.push_back(line("dt = " + number(dt) + " s", points));
  }
  lines.push_back(line("right", {{0, 1}, {kLongSeconds, 1}}, "bound"));
  return trial(
      "long", last,
      "after 100 s it has " + number(last, "%.2g") + " times the energy, with dt = 0.001 s", lines);
}

}  // namespace

json trials(const Parameters& params) {
  return {impact(params), fall(params), tremble(params),
          slope(params),  thin(params), long_run(params)};
}

}  // namespace bounce::study
