// The exact motion: what holds of every motion at every scale, and what is known of it by other
// means: closed forms, a second precision, and schemes that find no times of impact.
#include <gtest/gtest.h>

#include "cases.hpp"
#include "exact/first_contact.hpp"
#include "exact/truth.hpp"
#include "methods/moreau_jean.hpp"
#include "methods/scheme.hpp"

namespace bounce::study::tests {
namespace {

Motions motion_at(const Case& c, const std::vector<double>& times, EventReport* report = nullptr,
                  EventOptions options = {}) {
  return simulate_events<double>(c.params, c.start, times, options, report);
}

// A corner is l / sqrt(2) away from the centre: in a small turn, it moves by that times the turn.
TEST(exact, TellsHowFarPosesAreApartByTheWayOfACorner) {
  Scene scene{};
  const Motion<double> one{0, 1, 0, 0, 0, 0}, moved{0.03, 1.04, 0, 0, 0, 0};
  const Motion<double> turned{0, 1, 1e-3, 0, 0, 0};
  EXPECT_NEAR(distance(scene, one, moved), 0.05, 1e-15);
  const double corner = scene.params.l / std::sqrt(2.0);
  EXPECT_NEAR(distance(scene, one, turned), 1e-3 * corner, 1e-15);
}

// --- every motion ---

// How far rounding alone can sink a corner, m: that of y, of theta and of the time; and what counts
// as touching.
double rounding_depth(const Case& c, const Motion<double>& s, double t) {
  const double corner_speed = std::abs(s.v_y) + c.params.l * std::abs(s.omega);
  return 1e-13 * c.params.l +
         0x1p-48 * (std::abs(s.y) + c.params.l * (1 + std::abs(s.theta)) + t * corner_speed);
}

Case ordinary(Random& random, int i) { return ordinary_case(random, i, 0.79); }

struct Kind {
  const char* name;
  Case (*make)(Random&, int);
  int samples;
  bool loses_energy;  // Newton's law does so only where epsilon is small
};

const Kind kKinds[] = {
    {"ordinary", ordinary, 50, true},
    {"rocking", rocking_case, 20, false},
    {"wide", wide_case, 20, false},
};

TEST(exact, EveryMotionEndsAndNeitherSinksNorGainsEnergy) {
  for (const Kind& kind : kKinds) {
    Random random(3);
    for (int i = 0; i < random_cases(2000); ++i) {
      SCOPED_TRACE(kind.name + std::string(" ") + std::to_string(i));
      const Case c = kind.make(random, i);
      const Body<double> body(c.params);
      EventReport report;
      const Motions motions = motion_at(c, even_times(c.until, kind.samples), &report);
      ASSERT_FALSE(report.stalled);
      ASSERT_EQ(motions.size(), std::size_t(kind.samples));
      double before = energy(c.start, body);
      const double rounding = 1e-13 * (std::abs(before) + 10);
      for (int j = 0; j < kind.samples; ++j) {
        const Motion<double>& s = motions[std::size_t(j)];
        ASSERT_TRUE(std::isfinite(s.x + s.y + s.theta + s.v_x + s.v_y + s.omega));
        const double t = c.until * (j + 1) / kind.samples;
        ASSERT_GE(lowest_gap(s, body), -rounding_depth(c, s, t)) << "at " << t;
        const double now = energy(s, body);
        if (kind.loses_energy) {
          ASSERT_LE(now, before + rounding) << "at " << t;
        }
        before = now;
      }
    }
  }
}

// A change of the case, and what it does to a motion.
struct Symmetry {
  const char* name;
  Case (*make)(Random&, int);
  void (*change)(Case&);
  Motion<double> (*expected)(const Motion<double>&);
  double shift = 0;  // of x, m, which rounds it anew at each event; nothing else changes by a bit
};

constexpr double kLength = 0x1p-17, kTime = 0x1p6;

Motion<double> in_other_units(const Motion<double>& s) {
  const double speed = kLength / kTime;
  return {s.x * kLength, s.y * kLength, s.theta, s.v_x * speed, s.v_y * speed, s.omega / kTime};
}

void change_units(Case& c) {
  c.params.l *= kLength;
  c.params.g *= kLength / (kTime * kTime);
  c.until *= kTime;
  c.start = in_other_units(c.start);
}

Motion<double> mirrored(const Motion<double>& s) {
  return {-s.x, s.y, -s.theta, -s.v_x, s.v_y, -s.omega};
}

void mirror(Case& c) {
  c.params.g.x() *= -1;
  c.start = mirrored(c.start);
}

constexpr double kShift = 3, kEvents = 1000;  // m, and how often x may have been rounded

Motion<double> shifted(const Motion<double>& s) {
  return {s.x + kShift, s.y, s.theta, s.v_x, s.v_y, s.omega};
}

// Flat, at rest or sliding, on slopes to almost vertical: it stays, slides or tips over.
Case on_a_slope(Random& random, int i) {
  Case c = ordinary(random, i);
  const double tilt = random.uniform(0.05, 1.5);
  c.params.g = Vector3(9.81 * std::sin(tilt), -9.81 * std::cos(tilt), 0);
  c.params.mu = random.uniform(0.1, 1.3);
  c.start = {0, c.params.l / 2, 0, i % 2 == 0 ? 0 : random.uniform(-1, 1), 0, 0};
  c.until = 3 * c.unit_time();
  return c;
}

const Symmetry kSymmetries[] = {
    {"units", wide_case, change_units, in_other_units},
    {"mirror", wide_case, mirror, mirrored},
    {"mirror, in the air", ordinary, mirror, mirrored},
    {"mirror, rocking", rocking_case, mirror, mirrored},
    {"mirror on slopes", on_a_slope, mirror, mirrored},
    {"shift", wide_case, [](Case& c) { c.start = shifted(c.start); }, shifted, kShift},
};

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

void expect_same(const Motion<double>& one, const Motion<double>& other, double x_rounding = 0,
                 double theta_rounding = 0) {
  ASSERT_NEAR(one.x, other.x, x_rounding);
  ASSERT_NEAR(one.theta, other.theta, theta_rounding);
  for (const auto number :
       {&Motion<double>::y, &Motion<double>::v_x, &Motion<double>::v_y, &Motion<double>::omega})
    ASSERT_EQ(one.*number, other.*number);
}

TEST(exact, ChangesWithTheUnitsAMirrorAndAShiftAsItShould) {
  for (const Symmetry& symmetry : kSymmetries) {
    Random random(8);
    for (int i = 0; i < random_cases(1000) / 2; ++i) {
      SCOPED_TRACE(symmetry.name + std::string(" ") + std::to_string(i));
      Case c = symmetry.make(random, i);
      const Motions here = motion_at(c, even_times(c.until, 10));
      symmetry.change(c);
      const Motions there = motion_at(c, even_times(c.until, 10));
      ASSERT_EQ(here.size(), there.size());
      double farthest = std::abs(c.start.x);
      for (std::size_t j = 0; j < here.size(); ++j) {
        farthest = std::max(farthest, std::abs(there[j].x)) + symmetry.shift;
        const double rounding = symmetry.shift == 0 ? 0 : kEvents * kEpsilon * farthest;
        expect_same(there[j], symmetry.expected(here[j]), rounding);
        if (HasFatalFailure()) return;
      }
    }
  }
}

// The motion from an angle of many turns is that from what is left of it, and the turns.
TEST(exact, CountsWholeTurnsApart) {
  Random random(8);
  for (int i = 0; i < random_cases(1000) / 2; ++i) {
    SCOPED_TRACE(i);
    Case c = wide_case(random, i);
    const double theta = c.start.theta;
    if (std::abs(theta) <= std::numbers::pi) continue;
    const Motions turned = motion_at(c, even_times(c.until, 10));
    c.start.theta = std::atan2(std::sin(theta), std::cos(theta));
    const double turns = std::round((theta - c.start.theta) / (2 * std::numbers::pi));
    const Motions within = motion_at(c, even_times(c.until, 10));
    ASSERT_EQ(turned.size(), within.size());
    double fastest = std::abs(c.start.omega);
    for (std::size_t j = 0; j < within.size(); ++j) {
      Motion<double> expected = within[j];
      expected.theta += turns * 2 * std::numbers::pi;
      fastest = std::max(fastest, std::abs(expected.omega));
      const double turned_by = std::abs(theta) + fastest * c.until;
      expect_same(turned[j], expected, 0, 4 * kEpsilon * turned_by);
      if (HasFatalFailure()) return;
    }
  }
}

// Where it touches nothing, not even at the start, to which it comes back; else through the ground.
TEST(exact, FliesBackTheWayItCame) {
  Random random(8);
  for (int i = 0; i < random_cases(1000) / 2; ++i) {
    SCOPED_TRACE(i);
    Case c = wide_case(random, i);
    EventReport report;
    EventOptions options;
    const Motion<double> start = c.start;
    motion_at(c, {c.until}, &report);
    const double gap = lowest_gap(start, Body<double>(c.params));
    if (report.impacts > 0 || gap < 1e-6 * c.params.l) options.model.corners = 0;
    c.start = motion_at(c, {c.until}, nullptr, options).back();
    const double v_x = std::abs(start.v_x) + std::abs(c.start.v_x);
    const double v_y = std::abs(start.v_y) + std::abs(c.start.v_y);
    const double turned = std::abs(start.omega) * c.until;
    c.start.v_x *= -1, c.start.v_y *= -1, c.start.omega *= -1;
    const Motion<double> back = motion_at(c, {c.until}, nullptr, options).back();
    EXPECT_NEAR(back.x, start.x, 4 * kEpsilon * (std::abs(start.x) + v_x * c.until));
    EXPECT_NEAR(back.y, start.y, 4 * kEpsilon * (std::abs(start.y) + v_y * c.until));
    EXPECT_NEAR(back.theta, start.theta, 4 * kEpsilon * (std::abs(start.theta) + turned));
    EXPECT_NEAR(back.v_x, -start.v_x, 4 * kEpsilon * v_x);
    EXPECT_NEAR(back.v_y, -start.v_y, 4 * kEpsilon * v_y);
    if (HasFailure()) return;
  }
}

// A flat square at rest on a slope tips over the corner on which the ground presses, whichever side
// that is. x is what a program of other code and other precision found.
TEST(exact, TipsOverTheLowerCorner) {
  for (const double side : {-1.0, 1.0}) {
    Case c;
    c.params = {.l = 1, .m = 1, .mu = 1.3, .epsilon = 0.5, .g = {10 * side, -9, 0}};
    c.start = {0, 0.5, 0, 0, 0, 0};
    c.until = 1;
    const Motion<double> end = motion_at(c, {1}).back();
    EXPECT_NEAR(end.x, side * 0.700093042455138, 1e-12);
    EXPECT_LT(side * end.theta, 0);
  }
}

// A corner slips so slowly that its speed is a double root, and stops again within the same series.
// x is what second_truth.f90 found.
TEST(exact, StopsSlidingAfterASlowSlip) {
  Case c;
  c.params = {.l = 0.6335838661091093,
              .m = 1,
              .mu = 0.06789676678315267,
              .epsilon = 0.009136186274646069,
              .g = {1.8380221630178086, -9.63627389234321, 0}};
  c.start = {0,
             0.8271743191829698,
             1.566767595363154,
             1.1539143202142776,
             -2.216357298000254,
             3.9078457395137214};
  EXPECT_NEAR(motion_at(c, {0.5607636930258885}).back().x, 0.8073283149563616672, 1e-12);
}

// --- what is known in closed form, or has no end ---

Motions motions(const Parameters& params, const Motion<double>& start,
                const std::vector<double>& times) {
  return simulate_events<double>(params, start, times, {});
}

TEST(exact, NeedsNoGravity) {
  Parameters params;
  params.g.setZero();
  params.epsilon = 1;
  for (const double speed : {1e-7, 1.0, 1e7}) {
    const auto s = motions(params, {0, 1, 0, 0, -speed, 0}, {0.5 / speed, 2 / speed});
    EXPECT_NEAR(s[0].y, 0.5, 1e-15) << speed;
    EXPECT_NEAR(s[1].y, 1.2, 1e-15) << "it falls by 0.9 m and bounces";
  }
  EXPECT_EQ(motions(params, {0, 0.1, 0, 0, 0, 0}, {1.0}).at(0).y, 0.1);
}

// Of a flat side, one corner comes down by 1 m/s and bounces, and the other one leaves by 0.1 m/s:
// the impulse of the first would press it into the ground, which stops it there.
TEST(exact, GivesNoRestitutionToACornerThatLeaves) {
  Parameters params;
  params.g.setZero();
  params.mu = 0;
  const auto s = motions(params, {0, params.l / 2, 0, 0, -0.45, 1.1 / params.l}, {1e-9}).at(0);
  EXPECT_NEAR(s.v_y, params.epsilon / 2, 1e-9);
  EXPECT_NEAR(s.omega, -params.epsilon / params.l, 1e-9);
}

// Where a <= mu |b|, accelerations have no solution: the corner below the centre leans back from
// the way it slides.
TEST(exact, JamsWhereAccelerationsHaveNoSolution) {
  Parameters params;
  params.mu = 3;
  const double lean = std::atan(0.5), rho = params.l / std::sqrt(2.0);
  for (const double sign : {-1.0, 1.0}) {
    const double theta = std::atan(1.0) - sign * lean;
    const auto s = motions(params, {0, rho * std::cos(lean), theta, -sign, 0, 0}, {1e-6});
    EXPECT_GT(std::abs(s[0].omega), 1) << "the corner has stopped, and the square tips over it";
  }
}

// One corner cannot carry a face: the square rocks ever faster.
TEST(exact, ReportsThatEventsGoOnWithoutAnEnd) {
  Case c;
  c.start = {0, 0.3, 0, 0, 0, 0};
  EventOptions options;
  options.model.corners = 1;
  EventReport report;
  EXPECT_LT(motion_at(c, even_times(2.0, 10), &report, options).size(), 10u);
  EXPECT_TRUE(report.stalled);
}

// --- another precision, other tolerances ---

TEST(exact, IsTheSameInLongDouble) {
  for (const Scene& scene : scenes()) {
    const auto start = motion_of(scene.start);
    const auto usual = motions(scene.params, start, even_times(scene.until));
    const bool magnifies = scene.name == "ten_seconds";  // each of its impacts, errors of before
    EXPECT_LE(error_of(scene, usual, truth_of(scene)), magnifies ? 1e-8 : 1e-9) << scene.name;
    EXPECT_TRUE(std::isinf(error_of(scene, {}, truth_of(scene)))) << scene.name;
  }
}

// --- beside Moreau-Jean, which finds no times of impact ---

constexpr int kTimes = 20;

// In units of l.
double apart(const Case& c, const Motions& one, const Motions& other) {
  Scene scene{};
  scene.params = c.params;
  return error_of(scene, one, other) / c.params.l;
}

// How far a motion comes that begins as far off as a step's way, which is what being late by a step
// may do; and whose corners strike together where a step finds them both low.
double sensitivity(const Case& c, const Motions& motions, double way) {
  double worst = 0;
  for (const double share : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    for (const double turn : {-1.0, 0.0, 1.0}) {
      for (const double touching : {EventOptions().touching, 3 * share * way}) {
        Case other = c;
        other.start.y += 3 * share * way * c.params.l;
        other.start.theta += turn * share * way;
        EventOptions options;
        options.touching = touching;
        const Motions late = motion_at(other, even_times(c.until, kTimes), nullptr, options);
        worst = std::max(worst, apart(c, motions, late));
      }
    }
  }
  return worst;
}

TEST(exact, AgreesWithMoreauJeanAsFarAsItsStepsAreExact) {
  Random random(11);
  constexpr long kSteps = 2500;  // between two samples
  const int cases = random_cases(1000) / 10;
  int agree = 0;
  for (int i = 0; i < cases; ++i) {
    Case c = wide_case(random, i);
    c.until = std::min(c.until, 10 * c.unit_time());
    c.start.theta = std::remainder(c.start.theta, 2 * std::numbers::pi);
    c.params.dt = c.until / double(kTimes * kSteps);
    const Motions exact = motion_at(c, even_times(c.until, kTimes));
    const auto stepped = sample(MoreauJean<2>(c.params), c.start, kTimes, kSteps);
    const auto speed = [&](const auto& s) {
      return std::hypot(s.v_x, s.v_y, s.omega * c.params.l);
    };
    double fastest = std::max(c.unit_speed(), speed(c.start));
    for (const auto& s : exact) fastest = std::max(fastest, speed(s));
    const double way = fastest * c.params.dt / c.params.l, error = apart(c, exact, stepped);
    agree += error <= 10 * way;
    if (error <= 10 * way || c.params.mu > 4.0 / 3) continue;  // above, there may be more solutions
    EXPECT_LE(error, 10 * sensitivity(c, exact, way)) << i;
  }
  EXPECT_GT(agree, cases / 2);
}

}  // namespace
}  // namespace bounce::study::tests
