// A contact's impulses: the laws of impact, the solvers of its LCP, and where each of them fails.
#include <gtest/gtest.h>

#include <algorithm>

#include "cases.hpp"
#include "methods/gauss_seidel.hpp"
#include "methods/impact_laws.hpp"
#include "methods/lemke.hpp"
#include "methods/two_corners.hpp"

namespace bounce::study::tests {
namespace {

Collision<double> collision(double alpha, double v_n, double v_t, double mu, double epsilon) {
  const auto k = leaning_corner(alpha, 0, 0, mu);
  return {k.a, k.b, k.c, v_n, v_t, mu, epsilon};
}

double gain(const Collision<double>& k, ImpactLaw law) { return energy_gained(k, impact(k, law)); }

// --- the laws of impact ---

TEST(impact, KeepsFrictionInItsConeStopsApproachAndGainsNoEnergy) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const double mu = i % 5 == 0 ? 0 : random.uniform(0, 1.3);
    const auto k = collision(random.uniform(-1.5, 1.5), -random.uniform(0.01, 1),
                             random.uniform(-3, 3), mu, random.uniform(0, 1));
    for (const ImpactLaw law : {ImpactLaw::newton, ImpactLaw::poisson, ImpactLaw::stronge}) {
      const auto p = impact(k, law);
      ASSERT_LE(std::abs(p.t), k.mu * p.n + 1e-13) << i;
      ASSERT_GE(k.v_n + k.a * p.n + k.b * p.t, -1e-13) << i;
      if (law != ImpactLaw::newton) {
        ASSERT_LE(gain(k, law), 1e-13) << i;
      }
      if (mu == 0) {
        ASSERT_NEAR(p.n, (1 + k.epsilon) / k.a * -k.v_n, 1e-10) << "without friction, all are one";
      }
    }
  }
}

TEST(impact, NewtonsLawGainsEnergyAboveTheLimitAndNotBelow) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const double alpha = random.uniform(0.05, 1.5), mu = random.uniform(0.01, 1.2);
    const auto k = leaning_corner(alpha, 0, 0, mu);
    const double limit = gain_limit(k.a, k.b, k.c, mu);
    ASSERT_GE(limit, std::sqrt(1 - k.b * k.b / (k.a * k.c)) - 1e-15);
    double above = -1, below = -1;
    for (double v_t = -2; v_t <= 2; v_t += 1e-3) {
      above = std::max(above, gain(collision(alpha, -1, v_t, mu, limit + 5e-3), ImpactLaw::newton));
      below = std::max(below, gain(collision(alpha, -1, v_t, mu, limit - 1e-6), ImpactLaw::newton));
    }
    EXPECT_TRUE(above > 0 || limit >= 0.99) << alpha << " " << mu;
    EXPECT_LE(below, 1e-12) << alpha << " " << mu;
  }
}

// --- one corner ---

// How far (p_n, p_t) is from a solution, m/s.
double residual(const OneCorner<double>& k, double p_n, double p_t) {
  const double v_n = k.a * p_n + k.b * p_t + k.u_n, v_t = k.b * p_n + k.c * p_t + k.u_t;
  const double slides = k.mu * p_n - std::abs(p_t);  // 0 on the cone's edge
  return std::max({-p_n, -v_n, std::min(p_n, v_n), -slides, std::min(slides, std::abs(v_t)),
                   std::min(p_t * v_t, std::abs(v_t))});
}

GaussSeidel swept(const OneCorner<double>& k, int most) {
  Eigen::Matrix2d G;
  G << k.a, k.b, k.b, k.c;
  return gauss_seidel(G, Eigen::Vector2d(k.u_n, k.u_t), k.mu, 1e-13, most);
}

TEST(one_corner, IsSolvedAlikeInClosedFormAndBySweeps) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const auto k = leaning_corner(random.uniform(-1.5, 1.5), random.uniform(-1, 0.2),
                                  random.uniform(-5, 5), random.uniform(0, 1.2));
    const auto p = solve_one_corner(k);
    ASSERT_LE(residual(k, p.n, p.t), 1e-12 * (1 + p.n)) << i;
    const auto by_sweeps = swept(k, 100'000);
    ASSERT_TRUE(by_sweeps.converged) << i;
    ASSERT_LE((by_sweeps.p.head<2>() - Eigen::Vector2d(p.n, p.t)).norm(), 1e-9 * (1 + p.n)) << i;
  }
}

TEST(one_corner, HasOneSolutionBelowMuStarAndSometimesMoreAbove) {
  Random random(5);
  int several = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto k = leaning_corner(random.uniform(-1.5, 1.5), random.uniform(-1, 1),
                                  random.uniform(-5, 5), random.uniform(0, 4));
    const auto found = all_solutions(k);
    ASSERT_GE(found.size(), 1u) << i;
    ASSERT_TRUE(found.size() == 1 || k.a <= k.mu * std::abs(k.b)) << i;
    for (const auto& p : found) ASSERT_LE(residual(k, p.n, p.t), 1e-9 * (1 + p.n * p.n)) << i;
    several += found.size() > 1;
  }
  EXPECT_GT(several, 500);
}

// --- two corners: a side that lands ---

struct Side {
  Lcp8 lcp;
  LemkeResult lemke;
  SideImpulse<double> merged;

  // How far Lemke's impulses are from the merged ones, all of them together, m/s.
  double apart(const Parameters& params) const {
    const Eigen::VectorXd z = lemke.z * (params.dt / params.m);
    return std::max({std::abs(z(0) - merged.n[0]), std::abs(z(4) - merged.n[1]),
                     std::abs(z(2) - z(1) + z(6) - z(5) - merged.t)});
  }
};

Side side_at(double theta, const Vector3& v, const Parameters& params = {}) {
  const auto r = arms(params.l / 2, std::cos(theta), std::sin(theta));
  Side side{form_lcp8(r[2], r[3], v, params), {}, {}};
  const Eigen::VectorXd& p = side.lcp.p;
  side.merged = solve_two_corners(two_corners<double>(r[2], r[3], params.l * params.l / 6,
                                                      {p(0), p(4)}, (p(2) + p(6)) / 2, params.mu));
  side.lemke = lemke(side.lcp.V, p);
  return side;
}

TEST(two_corners, AreTheEightByEightOfAFlatSideAndSolvedHoweverNearlyFlat) {
  Random random(3);
  for (int i = 0; i < 14'000; ++i) {
    const double theta = i % 14 == 0 ? 0 : random.uniform(0.1, 3) * std::pow(10, -(i % 14) - 2);
    Parameters params;
    params.l = random.uniform(0.1, 2);
    params.mu = i % 5 == 0 ? 0 : random.uniform(0, 1.3);
    const Vector3 v(random.uniform(-2, 2), -random.uniform(0, 4), random.uniform(-20, 20));
    const Side side = side_at(theta, v, params);
    ASSERT_LE(side.merged.violation, 1e-12) << i;
    if (theta == 0) {
      ASSERT_LE(side.apart(params), 1e-9) << i;
    }
  }
  const Side flat = side_at(0, Vector3(0, -1, 0));
  EXPECT_DOUBLE_EQ(flat.merged.n[0], flat.merged.n[1]);
  EXPECT_EQ(flat.merged.t, 0);
}

TEST(two_corners, AlmostFlatMakeTheEightByEightSaySolvedWhereItIsNot) {
  const Vector3 v(0.67769883376658191, -0.23737549828107207, 19.956074175907368);
  const Side side = side_at(4.2195760913384079e-12, v);
  EXPECT_TRUE(side.lemke.is_solved);
  EXPECT_GT(lcp_residual(side.lcp.V, side.lcp.p, side.lemke.z), 0.5) << "m/s";
  EXPECT_LE(side.merged.violation, 1e-15);
}

}  // namespace
}  // namespace bounce::study::tests
