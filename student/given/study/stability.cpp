#include "stability.hpp"

#include <algorithm>
#include <bounce/part3_step.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure.hpp"
#include "numbers.hpp"

namespace bounce::study {
namespace {

constexpr double kCoarse = 1e-2, kFine = 1e-3;  // s
constexpr double kRestSeconds = 10, kSlopeSeconds = 1, kLongSeconds = 100;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = std::numbers::pi / 180;
const std::string kNothing = "NaN, or another number of columns: ./check says where";

// ---- large epsilon with friction ----

// The most that one impact adds to the energy, as a share of what the corner's motion had, over
// landings in every direction on a corner; without gravity, so that the lift adds nothing.
double largest_gain(Parameters params, double epsilon, double mu) {
  params.g.setZero();
  params.epsilon = epsilon;
  params.mu = mu;
  const double gyration = params.l * params.l / 6, arm = params.l / std::numbers::sqrt2;
  const auto energy = [&](const Vector3& v) {  // over m/2
    return v(0) * v(0) + v(1) * v(1) + gyration * v(2) * v(2);
  };
  double largest = -1;
  for (int lean = -15; lean <= 15; ++lean) {
    const double a = lean * 3 * kDegree * 0.97;
    const double r_x = arm * std::sin(a), r_y = -arm * std::cos(a);
    // The motion v = M^-1 J f in which the corner moves by u = J^T v, and nothing else moves.
    const double tt = 1 + r_y * r_y / gyration, nn = 1 + r_x * r_x / gyration,
                 tn = -r_x * r_y / gyration, determinant = tt * nn - tn * tn;
    for (int from = -88; from <= 88; from += 2) {
      const double u_t = std::sin(from * kDegree), u_n = -std::cos(from * kDegree);
      const double f_t = (nn * u_t - tn * u_n) / determinant;
      const double f_n = (tt * u_n - tn * u_t) / determinant;
      const Vector3 v(f_t, f_n, (r_x * f_n - r_y * f_t) / gyration);
      const Vector3 q(0, -r_y + params.delta / 2, std::numbers::pi / 4 + a);
      const double gain = energy(step(q, v, params).v) / energy(v) - 1;
      if (!std::isfinite(gain)) return kNone;
      largest = std::max(largest, gain);
    }
  }
  return largest;
}

Trial impact(const Parameters& params) {
  double first = 2, most = 0;
  std::vector<Line> lines;
  for (const double mu : {0.1, 0.3, 1.0}) {
    Points points;
    for (int i = 0; i <= 100; i += i < 70 ? 10 : 1) {
      const double epsilon = i / 100.0, gain = largest_gain(params, epsilon, mu);
      points.emplace_back(epsilon, 100 * gain);
      if (gain > 1e-9) first = std::min(first, epsilon);
      most = std::isnan(gain) ? kNone : std::max(most, gain);
    }
    lines.push_back({"mu = " + number(mu), points});
  }
  lines.push_back({"no gain", {{0, 0}, {1, 0}}, "bound"});
  const std::string found = std::isnan(most) ? kNothing
                            : first > 1      ? "no impact gains energy"
                                             : "from epsilon = " + number(first) +
                                              " on some impacts gain energy, up to " +
                                              number(100 * most, "%.2g") + " %";
  return {"an impact gains no energy",
          found,
          {"impact",
           "Large epsilon with friction",
           {"epsilon", false},
           {"largest gain of an impact, %", false},
           lines,
           "Each dot is the largest gain over 2,759 landings on a corner, of what the corner's "
           "motion had as energy. Newton's law sets the corner's normal velocity, whatever "
           "friction does to the spin: question 3 of Explore."}};
}

// ---- fast fall ----

// How deep a corner gets that comes down at this speed, over eight moments in a step at which it
// reaches the ground.
double depth(const Parameters& params, double speed, double dt) {
  double deepest = 0;
  for (int k = 0; k < 8; ++k) {
    const double y = params.l / std::numbers::sqrt2 + params.delta + speed * dt * k / 8;
    const auto moved = motion({{0, y, 45 * kDegree}, {0, -speed, 0}}, params, dt, 4 * dt);
    if (!moved) return kNone;
    for (const auto& q : moved->q.colwise()) {
      deepest = std::max(deepest, -heights(q, params.l)[0]);
    }
  }
  return deepest;
}

Trial fall(const Parameters& params) {
  std::vector<Line> lines;
  double at_60 = 0;
  for (const double dt : {kCoarse, kFine}) {
    Points points, bound;
    for (const double speed : {1.0, 2.0, 5.0, 10.0, 20.0, 60.0, 100.0}) {
      points.emplace_back(speed, depth(params, speed, dt));
      bound.emplace_back(speed, speed * dt);
      if (speed == 60 && dt == kCoarse) at_60 = points.back().second;
    }
    const std::string with = "dt = " + number(dt) + " s";
    lines.push_back({with, points});
    lines.push_back({"v dt, " + with, bound, "bound"});
  }
  return {"the corner stays above the ground",
          std::isnan(at_60) ? kNothing
                            : "at 60 m/s it sinks in by " + length(at_60) + ", " +
                                  number(at_60 / params.l, "%.2g") + " sides",
          {"fall",
           "Fast fall",
           {"speed of the fall, m/s", true},
           {"deepest penetration, m", true},
           lines,
           "A step notices contact at its start, so a corner may fall for a whole step below the "
           "ground: by up to v dt. Half the step halves it; what cures it is to look for the "
           "moment of the impact within the step: question 6 of Explore."}};
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
  Rest far{0, moved->q.row(0).cwiseAbs().maxCoeff(), 0};
  far.up = std::max(0.0, moved->q.row(1).maxCoeff() - params.l / 2);
  for (const auto& q : moved->q.colwise())
    far.below = std::max(far.below, -heights(q, params.l)[0]);
  return far;
}

Trial tremble(const Parameters& params) {
  Points up, up_scaled, along, along_scaled;
  for (const double dt : {2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4}) {
    const Rest fixed = rest(params, dt, params.delta), scaled = rest(params, dt, kShare * dt);
    up.emplace_back(dt, fixed.up);
    up_scaled.emplace_back(dt, scaled.up);
    along.emplace_back(dt, fixed.along);
    along_scaled.emplace_back(dt, scaled.along);
  }
  const Rest usual = rest(params, kCoarse, params.delta);
  return {"it lies still",
          std::isnan(usual.up) ? kNothing
                               : "it trembles, up to " + length(usual.up) +
                                     " above where it should lie, and wanders by " +
                                     length(usual.along) + " in ten seconds",
          {"rest",
           "Rest on a face",
           {"dt, s", true},
           {"way in ten seconds, m", true},
           {{"up, delta fixed", up},
            {"up, delta = 0.1 m/s dt", up_scaled},
            {"along, delta fixed", along},
            {"along, delta = 0.1 m/s dt", along_scaled}},
           "One corner's force turns a square that lies on two: it rocks, and wanders. Each step "
           "in contact lifts it by delta, however small dt is: questions 2 and 4 of Explore."}};
}

// ---- tilted ground ----

Trial slope(const Parameters& params) {
  std::vector<Line> lines;
  Points right;
  double at_10 = 0;
  for (const double dt : {kCoarse, kFine}) {
    Points points;
    for (int tilt = 0; tilt <= 30; tilt += 2) {
      const double along = 9.81 * std::sin(tilt * kDegree), down = 9.81 * std::cos(tilt * kDegree);
      Parameters tilted = params;
      tilted.g = Vector3(along, -down, 0);
      const auto moved = motion({{0, params.l / 2, 0}, Vector3::Zero()}, tilted, dt, kSlopeSeconds);
      points.emplace_back(tilt, moved ? moved->q(0, moved->q.cols() - 1) : kNone);
      if (tilt == 10 && dt == kFine) at_10 = points.back().second;
      if (dt == kCoarse)
        right.emplace_back(
            tilt, std::max(0.0, 0.5 * (along - params.mu * down) * kSlopeSeconds * kSlopeSeconds));
    }
    lines.push_back({"dt = " + number(dt) + " s", points});
  }
  lines.push_back({"right", right, "bound"});
  return {"friction holds it up to " + number(std::atan(params.mu) / kDegree) + " degrees",
          std::isnan(at_10) ? kNothing
                            : "on 10 degrees it creeps " + length(std::abs(at_10)) +
                                  " in a second, with dt = 0.001 s",
          {"slope",
           "Tilted ground",
           {"tilt, degrees", false},
           {"way down in a second, m", false},
           lines,
           "While the square rocks from corner to corner, gravity pulls it along in each short "
           "flight, and no friction brakes it there. A smaller step doesn't help."}};
}

// ---- thin contact ----

Trial thin(const Parameters& params) {
  std::vector<Line> lines;
  double at_least = 0;
  for (const double dt : {kCoarse, kFine}) {
    Points points;
    for (double delta = 1e-2; delta > 5e-7; delta /= std::sqrt(10)) {
      points.emplace_back(delta, rest(params, dt, delta).below);
    }
    if (dt == kCoarse) at_least = points.back().second;
    lines.push_back({"dt = " + number(dt) + " s", points});
  }
  return {"it stays on the ground",
          std::isnan(at_least)
              ? kNothing
              : "with delta = 1 \xc2\xb5m it sinks in by " + length(at_least) + ", and stays there",
          {"thin",
           "Thin contact",
           {"delta, m", true},
           {"deepest in ten seconds at rest, m", true},
           lines,
           "In a step a corner falls by g dt\xc2\xb2, 0.98 mm with dt = 0.01 s, and the lift gives "
           "back "
           "delta. Where delta is less than that, the square sinks: delta can't be small alone."}};
}

// ---- long run ----

Trial long_run(Parameters params) {
  params.epsilon = 1;
  params.mu = 0;
  const State start{{0, 0.5, 0.3}, {1, 0, 5}};
  const auto energy = [&](const Vector3& q, const Vector3& v) {
    return 0.5 * v.dot(params.M() * v) - params.m * params.g.dot(q);
  };
  const double at_start = energy(start.q, start.v);
  std::vector<Line> lines;
  double last = 0;
  for (const double dt : {kCoarse, kFine}) {
    Points points;
    const auto moved = motion(start, params, dt, kLongSeconds);
    for (int i = 0; moved && i <= 100; ++i) {
      const Eigen::Index t = (moved->q.cols() - 1) * i / 100;
      points.emplace_back(static_cast<double>(t) * dt,
                          energy(moved->q.col(t), moved->v.col(t)) / at_start);
    }
    last = points.empty() ? kNone : points.back().second;
    lines.push_back({"dt = " + number(dt) + " s", points});
  }
  lines.push_back({"right", {{0, 1}, {kLongSeconds, 1}}, "bound"});
  return {"without friction and with epsilon = 1 the energy stays",
          std::isnan(last) ? kNothing
                           : "after 100 s it has " + number(last, "%.2f") +
                                 " times the energy, with dt = 0.001 s",
          {"long",
           "A long run",
           {"t, s", false},
           {"energy, start = 1", false},
           lines,
           "Each bounce is a step in contact, and its lift adds m g delta from nowhere; flight "
           "loses a little, as v' moves the square for the whole step: question 2 of Explore."}};
}

}  // namespace

std::vector<Trial> trials(const Parameters& params) {
  return {impact(params), fall(params), tremble(params),
          slope(params),  thin(params), long_run(params)};
}

}  // namespace bounce::study
