// The event-driven motion at every scale that parameters may have.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "methods/moreau_jean.hpp"
#include "methods/scheme.hpp"
#include "wide_cases.hpp"

namespace bounce::exact::tests {
namespace {

using methods::ImpactLaw;
using methods::Motion;

constexpr int kTimes = 20;

std::vector<Motion<double>> events(const WideCase& c, EventReport* report = nullptr) {
  EventOptions options;
  options.law = c.law;
  return simulate_events<double>(c.params, c.start, even_times(c.until, kTimes), options, report);
}

bool is_finite(const Motion<double>& s) {
  return std::isfinite(s.x + s.y + s.theta) && std::isfinite(s.v_x + s.v_y + s.omega);
}

TEST(every_scale, EndsAndSinksNoMoreThanRounding) {
  Random random(7);
  for (int i = 0; i < random_cases(1000); ++i) {
    const WideCase c = wide_case(random, i);
    const methods::Body<double> body(c.params);
    EventReport report;
    const auto motions = events(c, &report);
    ASSERT_FALSE(report.stalled) << i;
    ASSERT_EQ(motions.size(), std::size_t(kTimes)) << i;
    for (int j = 0; j < kTimes; ++j) {
      const Motion<double>& s = motions[std::size_t(j)];
      ASSERT_TRUE(is_finite(s)) << i;
      const double t = c.until * (j + 1) / kTimes;
      ASSERT_GE(methods::lowest_gap(s, body), -rounding_depth(c, s, t)) << i << " at " << t;
    }
  }
}

TEST(every_scale, IsTheSameInOtherUnits) {
  Random random(8);
  const double length = 0x1p-17, time = 0x1p6;
  for (int i = 0; i < random_cases(1000) / 10; ++i) {
    WideCase c = wide_case(random, i);
    const auto here = events(c);
    c.params.l *= length;
    c.params.g *= length / (time * time);
    c.until *= time;
    const double speed = length / time;
    Motion<double>& s = c.start;
    s = {s.x * length, s.y * length, s.theta, s.v_x * speed, s.v_y * speed, s.omega / time};
    const auto there = events(c);
    for (std::size_t j = 0; j < here.size(); ++j) {
      ASSERT_EQ(here[j].x * length, there[j].x) << i;
      ASSERT_EQ(here[j].y * length, there[j].y) << i;
      ASSERT_EQ(here[j].theta, there[j].theta) << i;
      ASSERT_EQ(here[j].v_x * speed, there[j].v_x) << i;
    }
  }
}

TEST(every_scale, CountsWholeTurnsApart) {
  Random random(9);
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < 100; ++i) {
    WideCase c = wide_case(random, i);
    c.until = std::min(c.until, 3 * c.unit_time());
    c.start.theta = std::atan2(std::sin(c.start.theta), std::cos(c.start.theta));
    const auto here = events(c);
    c.start.theta += 1024 * turn;  // rounds theta by 1e-12
    const auto there = events(c);
    if (std::abs(here.back().y - there.back().y) < 1e-6 * c.params.l) {
      ASSERT_NEAR(there.back().theta - here.back().theta, 1024 * turn, 1e-4) << i;
    }
  }
}

TEST(every_scale, NeedsNoGravity) {
  Parameters params;
  params.g.setZero();
  params.epsilon = 1;
  for (const double speed : {1e-7, 1.0, 1e7}) {
    const Motion<double> start{0, 1, 0, 0, -speed, 0};
    const auto s = simulate_events<double>(params, start, {0.5 / speed, 2 / speed}, {});
    EXPECT_NEAR(s[0].y, 0.5, 1e-15) << speed;
    EXPECT_NEAR(s[1].y, 1.2, 1e-15) << "it falls by 0.9 m and bounces";
  }
  const Motion<double> rest{0, params.l / 2, 0, 0, 0, 0};
  EXPECT_EQ(simulate_events<double>(params, rest, {1.0}, {}).at(0).y, rest.y);
}

TEST(every_scale, EndsZenoSequencesOnSlopesUnderEveryLaw) {
  for (const ImpactLaw law : {ImpactLaw::newton, ImpactLaw::poisson, ImpactLaw::stronge}) {
    WideCase c;
    c.law = law;
    c.params.l = 0.2;
    c.params.mu = 0.9116;
    c.params.epsilon = 0.68833;
    c.params.g = Vector3(5.2649, -7.3551, 0);
    c.start = {0, 0.100021007, -0.000210095, -0.21574, 0, 0};
    c.until = 10;
    EventReport report;
    EXPECT_EQ(events(c, &report).size(), std::size_t(kTimes));
    EXPECT_FALSE(report.stalled);
  }
}

// Drops of steep slopes, on which squares rock until they lie: where laws with friction in the
// expansion may come to rest in one contact only.
TEST(every_scale, RocksToRestOnSlopesUnderEveryLaw) {
  Random random(10);
  for (int i = 0; i < random_cases(1000); ++i) {
    WideCase c;
    c.law = ImpactLaw(i % 3);
    c.params.l = 0.2;
    c.params.mu = random.uniform(0.3, 1.2);
    c.params.epsilon = random.uniform(0, 0.9);
    const double tilt = random.uniform(0.3, 0.78);
    c.params.g = Vector3(9.81 * std::sin(tilt), -9.81 * std::cos(tilt), 0);
    const double theta = either_sign(random) * log_uniform(random, 1e-6, 1e-2);
    const double height = 0.1 * (std::abs(std::cos(theta)) + std::abs(std::sin(theta)));
    c.start = {0, height + log_uniform(random, 1e-9, 1e-2), theta, random.uniform(-1, 1), 0, 0};
    c.until = 5;
    EventReport report;
    const auto motions = events(c, &report);
    ASSERT_FALSE(report.stalled) << i;
    ASSERT_EQ(motions.size(), std::size_t(kTimes)) << i;
  }
}

// What bounces left out would have done to v_x is second order in the cut: 1e-12 here.
TEST(every_scale, LeavesOutBouncesWithoutChangingHowItSlides) {
  for (const double mu : {0.0, 0.1}) {
    Parameters params;
    params.mu = mu;
    const Motion<double> start{0, params.l / 2, 0, 3, 0, 9e-6};
    const std::vector<double> times{1.0, 10.0};
    const auto s = simulate_events<double>(params, start, times, {});
    EventOptions finer;
    finer.cut = 1e-9;
    const auto exact = simulate_events<long double>(params, {0, start.y, 0, 3, 0, start.omega},
                                                    {1.0L, 10.0L}, finer);
    for (std::size_t j = 0; j < times.size(); ++j)
      EXPECT_NEAR(s[j].x, double(exact[j].x), 2e-10) << mu << " after " << times[j];
    if (mu == 0) {
      EXPECT_NEAR(s[1].x, 30, 1e-10);
    }
  }
}

// --- beside Moreau-Jean, which finds no times of impact ---

double apart(const WideCase& c, const Motion<double>& one, const Motion<double>& other) {
  const double turned = c.params.l / std::sqrt(2.0) * (one.theta - other.theta);
  return std::hypot(one.x - other.x, one.y - other.y, turned) / c.params.l;
}

double apart(const WideCase& c, const std::vector<Motion<double>>& one,
             const std::vector<Motion<double>>& other) {
  if (one.size() != other.size()) return INFINITY;
  double worst = 0;
  for (std::size_t j = 0; j < one.size(); ++j) {
    const double error = apart(c, one[j], other[j]);
    worst = std::isnan(error) ? INFINITY : std::max(worst, error);
  }
  return worst;
}

// How far starts come that lie as far off as a step's way: what being late by a step may do.
double sensitivity(const WideCase& c, const std::vector<Motion<double>>& motions, double way) {
  double worst = 0;
  for (const double share : {0.1, 1.0, 3.0}) {
    for (const double turn : {-1.0, 0.0, 1.0}) {
      WideCase shifted = c;
      shifted.start.y += 3 * share * way * c.params.l;
      shifted.start.theta += turn * share * way;
      worst = std::max(worst, apart(c, motions, events(shifted)));
    }
  }
  return worst;
}

// How far the motion comes whose corners strike together where a step finds them both low.
double simultaneity(const WideCase& c, const std::vector<Motion<double>>& motions, double way) {
  double worst = 0;
  for (const double share : {0.3, 1.0, 3.0, 10.0}) {
    EventOptions options;
    options.touching = share * way;
    worst = std::max(worst, apart(c, motions,
                                  simulate_events<double>(c.params, c.start,
                                                          even_times(c.until, kTimes), options)));
  }
  return worst;
}

std::string compared_with_moreau_jean(WideCase c) {
  constexpr long kSteps = 2500;  // between two samples
  c.start.theta = std::atan2(std::sin(c.start.theta), std::cos(c.start.theta));
  const auto exact = events(c);
  Parameters params = c.params;
  params.dt = c.until / double(kTimes * kSteps);
  const auto stepped = methods::sample(methods::MoreauJean<2>(params, c.start), kTimes, kSteps);
  double fastest = c.unit_speed();
  for (const auto& s : exact)
    fastest = std::max(fastest, std::hypot(s.v_x, s.v_y, s.omega * c.params.l));
  const double way = fastest * params.dt / c.params.l, error = apart(c, exact, stepped);
  if (error <= 10 * way) return "agrees";
  if (error <= 10 * sensitivity(c, exact, way)) return "agrees as far as its steps are exact";
  if (error <= 10 * simultaneity(c, exact, way)) return "two corners strike within a step";
  if (c.params.mu > 4.0 / 3) return "contact problems may have several solutions";
  return "";
}

TEST(every_scale, AgreesWithMoreauJeanAtItsFinest) {
  Random random(11);
  std::map<std::string, int> counts;
  const int cases = random_cases(1000) / 10;
  for (int i = 0; i < cases; ++i) {
    WideCase c = wide_case(random, i);
    c.law = ImpactLaw::newton;
    c.until = std::min(c.until, 10 * c.unit_time());
    const std::string reason = compared_with_moreau_jean(c);
    EXPECT_NE(reason, "") << i;
    ++counts[reason];
  }
  for (const auto& [reason, count] : counts) std::cout << count << " " << reason << "\n";
  EXPECT_GT(counts["agrees"], cases / 2);
}

}  // namespace
}  // namespace bounce::exact::tests
