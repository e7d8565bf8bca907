// The event-driven truth, against what is known of it by other means.
#include <gtest/gtest.h>

#include <cmath>

#include "common.hpp"
#include "exact/event_driven.hpp"
#include "exact/first_contact.hpp"
#include "methods/moreau_jean.hpp"
#include "methods/scheme.hpp"
#include "study/catalog.hpp"

namespace bounce::exact::tests {
namespace {

using methods::ImpactLaw;

std::vector<Motion<double>> truth(const Parameters& params, const Motion<double>& start,
                                  const std::vector<double>& times, EventReport* report = nullptr,
                                  const EventOptions& options = {}) {
  return simulate_events<double>(params, start, times, options, report);
}

TEST(truth, SlidesAsFarAsFrictionLetsIt) {
  for (const double mu : {0.1, 0.3, 0.9}) {
    for (const double v : {-3.0, 0.5, 2.0}) {
      Parameters params;
      params.mu = mu;
      const auto s = truth(params, {0, 0.1, 0, v, 0, 0}, {100.0}).at(0);
      EXPECT_NEAR(s.x, v * std::abs(v) / (2 * mu * 9.81), 1e-12 * (1 + v * v / mu));
      EXPECT_EQ(s.v_x, 0);
      EXPECT_EQ(s.y, 0.1);
    }
  }
}

TEST(truth, EndsAFlatBounceAtTheSumOfTheGeometricSeries) {
  for (const double epsilon : {0.2, 0.5, 0.8}) {
    Parameters params;
    params.epsilon = epsilon;
    const double t_0 = std::sqrt(2 * 0.2 / 9.81), end = t_0 * (1 + epsilon) / (1 - epsilon);
    EventReport report;
    truth(params, {0, 0.3, 0, 0, 0, 0}, {end + 1}, &report);
    EXPECT_NEAR(report.flight, end, 4e-6 / (9.81 * (1 - epsilon))) << "what a cut of 2e-6 m/s is";
    const auto last = truth(params, {0, 0.3, 0, 0, 0, 0}, {end - 1e-3, end + 1e-9});
    EXPECT_GT(last[0].y, 0.1);
    EXPECT_EQ(last[1].y, 0.1);
  }
}

// The time in which a square pivots from theta to flat: the integral of dtheta / |omega|, with
// omega^2 = 2 g (height lost) / (r_g^2 + rho^2). With theta = start (1 - s^2) the integrand has no
// root at the start; midpoint rule.
double falling_time(double l, double start) {
  const double g = 9.81, rho = l / std::sqrt(2.0), quarter = std::atan(1.0);
  const auto height = [&](double theta) { return rho * std::sin(quarter + theta); };
  const int n = 200'000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n, theta = start * (1 - s * s);
    const double omega =
        std::sqrt(2 * g * (height(start) - height(theta)) / (l * l / 6 + rho * rho));
    sum += 2 * s * start / omega / n;
  }
  return sum;
}

TEST(truth, PivotsAsAPendulumDoes) {
  Parameters params;
  params.mu = 1.2;
  params.epsilon = 0;
  const double theta = 0.3, half = params.l / 2;
  const double y = half * (std::cos(theta) + std::sin(theta)), t = falling_time(params.l, theta);
  const auto s = truth(params, {0, y, theta, 0, 0, 0}, {t - 1e-7, t + 1e-7});
  EXPECT_NEAR(s[0].theta / s[0].omega, -1e-7, 1e-9) << "flat in another 1e-7 s";
  EXPECT_GT(s[1].omega, s[0].omega) << "it has landed";
  const methods::Body<double> body(params);
  EXPECT_NEAR(methods::energy(s[0], body), -body.g_y * y, 1e-13) << "nothing slides";
}

// The time of the first contact after flights near the ground and above.
double first_contact_time(Motion<double> s, const methods::Body<double>& body) {
  double t = 0;
  while (t < 5) {
    const double above = time_above(s, body);
    const NearFlight<double> flight =
        above > 0 ? NearFlight<double>{above, false} : first_contact(s, body, 5.0);
    t += flight.time;
    if (flight.contact) return t;
    s = fly(s, body, flight.time);
    if (above > 0) s.y = body.rho;
  }
  return t;
}

TEST(truth, FindsTheFirstContactOfWhateverCorner) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    Drop drop = random_drop(random, i, 1);
    const methods::Body<double> body(drop.params);
    drop.start.omega *= 5;
    if (methods::lowest_gap(drop.start, body) < 0) continue;
    const double t = first_contact_time(drop.start, body);
    ASSERT_LT(t, 5);
    for (int j = 0; j < 200; ++j)
      ASSERT_GT(methods::lowest_gap(fly(drop.start, body, t * j / 200), body), -1e-14) << i;
    ASSERT_NEAR(methods::lowest_gap(fly(drop.start, body, t), body), 0, 1e-12) << i;
  }
}

TEST(truth, IsWhatMoreauJeanConvergesTo) {
  for (const Scene& scene : scenes()) {
    const auto start = methods::motion_of<double>(scene.start);
    const auto exact = truth(scene.params, start, even_times(scene.until, 20));
    const auto error = [&](long steps) {
      Parameters params = scene.params;
      params.dt = scene.until / double(20 * steps);
      const auto s = methods::sample(methods::MoreauJean<2>(params, start), 20, steps);
      double worst = 0;
      for (std::size_t i = 0; i < 20; ++i) worst = std::max(worst, distance(scene, s[i], exact[i]));
      return worst;
    };
    EXPECT_LE(error(10'000), 2e-4) << scene.name;
    EXPECT_LE(error(10'000), error(50) / 10 + 1e-9) << scene.name;
  }
}

// A corner on the ground is as far from it as the series are from the truth: more than what counts
// as touching, with all but the last of these.
TEST(truth, GetsNearerWithTheToleranceWhereASecondCornerLands) {
  const Scene scene = scene_named("tilted_settling");
  const Samples exact = truth_of(scene);
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12}) {
    EventOptions options;
    options.tolerance = tolerance;
    options.cut = std::max(options.cut, std::sqrt(tolerance));
    const auto motions = truth(scene.params, methods::motion_of<double>(scene.start),
                               sample_times(scene), nullptr, options);
    EXPECT_LE(error_of(scene, motions, exact), 4e-3 * std::sqrt(tolerance)) << tolerance;
  }
}

TEST(truth, IsTheSameInLongDouble) {
  EventOptions finer;
  finer.tolerance = 1e-19;
  finer.cut = 1e-8;
  for (const Scene& scene : scenes()) {
    const auto start = methods::motion_of<double>(scene.start);
    const Motion<long double> long_start = methods::motion_of<long double>(scene.start);
    const auto usual = truth(scene.params, start, even_times(scene.until, 20));
    const auto longer = simulate_events<long double>(
        scene.params, long_start, even_times<long double>(scene.until, 20), finer);
    ASSERT_EQ(longer.size(), usual.size());
    for (std::size_t i = 0; i < usual.size(); ++i) {
      const Motion<long double>& s = longer[i];
      EXPECT_LE(distance(scene, usual[i], {double(s.x), double(s.y), double(s.theta), 0, 0, 0}),
                1e-9)
          << scene.name << " at sample " << i;
    }
  }
}

TEST(truth, MirrorsAMirroredScene) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    Drop drop = random_drop(random, i, 0.79);
    const auto times = even_times(1.0, 10);
    const auto here = truth(drop.params, drop.start, times);
    Motion<double>& s = drop.start;
    drop.params.g.x() *= -1;
    s = {-s.x, s.y, -s.theta, -s.v_x, s.v_y, -s.omega};
    const auto there = truth(drop.params, s, times);
    for (std::size_t j = 0; j < times.size(); ++j) {
      ASSERT_NEAR(here[j].x, -there[j].x, 1e-8) << i;
      ASSERT_NEAR(here[j].y, there[j].y, 1e-8) << i;
      ASSERT_NEAR(here[j].theta, -there[j].theta, 1e-7) << i;
    }
  }
}

// Newton's law promises not to gain energy only where epsilon is small; the others always do.
class Drops : public testing::TestWithParam<std::pair<ImpactLaw, double>> {};

TEST_P(Drops, NeverSinkNorGainEnergyNorFail) {
  Random random(3);
  EventOptions options;
  options.law = GetParam().first;
  for (int i = 0; i < 10'000; ++i) {
    const Drop drop = random_drop(random, i, GetParam().second);
    const methods::Body<double> body(drop.params);
    EventReport report;
    const auto motions = truth(drop.params, drop.start, even_times(1.0, 50), &report, options);
    ASSERT_FALSE(report.stalled) << i;
    ASSERT_EQ(motions.size(), 50u) << i;
    double before = methods::energy(drop.start, body);
    const double rounding = 1e-13 * (std::abs(before) + 10);
    for (const Motion<double>& s : motions) {
      ASSERT_GE(methods::lowest_gap(s, body), -1e-12) << i;
      const double now = methods::energy(s, body);
      ASSERT_LE(now, before + rounding) << i;
      before = now;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(TenThousand, Drops,
                         testing::Values(std::pair{ImpactLaw::newton, 0.79},
                                         std::pair{ImpactLaw::poisson, 1.0},
                                         std::pair{ImpactLaw::stronge, 1.0}),
                         [](const auto& law) {
                           return law.param.first == ImpactLaw::newton    ? "Newton"
                                  : law.param.first == ImpactLaw::poisson ? "Poisson"
                                                                          : "Stronge";
                         });

// One corner cannot carry a face: the square rocks ever faster.
TEST(truth, ReportsThatEventsGoOnWithoutAnEnd) {
  Parameters params;
  EventOptions options;
  options.model.corners = 1;
  EventReport report;
  const auto motions = truth(params, {0, 0.3, 0, 0, 0, 0}, even_times(2.0, 10), &report, options);
  EXPECT_TRUE(report.stalled);
  EXPECT_LT(motions.size(), 10u);
}

TEST(truth, JamsWhereAccelerationsHaveNoSolution) {
  Parameters params;
  params.mu = 3;
  const double lean = std::atan(0.5), rho = params.l / std::sqrt(2.0);
  // The corner below the centre, leaning back from the way it slides: a < mu |b|.
  for (const double sign : {-1.0, 1.0}) {
    const double theta = std::atan(1.0) - sign * lean;
    EventReport report;
    const auto s = truth(params, {0, rho * std::cos(lean), theta, -sign, 0, 0}, {1e-6}, &report);
    EXPECT_EQ(report.jams, 1);
    EXPECT_GT(std::abs(s[0].omega), 1) << "the corner has stopped, and the square tips over it";
  }
}

}  // namespace
}  // namespace bounce::exact::tests
