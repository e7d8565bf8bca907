#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "../exact/event_driven.hpp"
#include "../methods/assignment.hpp"
#include "../methods/gauss_seidel.hpp"
#include "../methods/impact_laws.hpp"
#include "../methods/lemke.hpp"
#include "../methods/moreau_jean.hpp"
#include "catalog.hpp"
#include "questions.hpp"
#include "random_scenes.hpp"

namespace bounce::study {
namespace {

// A corner's share of the energy, x^T G^-1 x / 2 with x = (v_n, v_t).
double energy_of(const Collision<double>& k) {
  return (k.c * k.v_n * k.v_n - 2 * k.b * k.v_n * k.v_t + k.a * k.v_t * k.v_t) /
         (2 * (k.a * k.c - k.b * k.b));
}

// The largest relative gain over the angles of a square and the directions of its velocity.
double largest_gain(ImpactLaw law, double mu, double epsilon) {
  double largest = -1;
  for (int i = 0; i <= 45; ++i) {
    const auto k = leaning_corner(i * std::numbers::pi / 180, 0, 0, mu);
    for (int j = -300; j <= 300; ++j) {
      const Collision<double> hit{k.a, k.b, k.c, -1, j / 100.0, mu, epsilon};
      largest = std::max(largest, energy_gained(hit, impact(hit, law)) / energy_of(hit));
    }
  }
  return largest;
}

// The least epsilon that can gain energy, over the same angles; 1 if none can.
double least_limit(double mu) {
  double least = 1;
  for (int i = 0; i <= 45; ++i) {
    const auto k = leaning_corner(i * std::numbers::pi / 180, 0, 0, mu);
    if (k.a > mu * std::abs(k.b)) least = std::min(least, gain_limit(k.a, k.b, k.c, mu));
  }
  return least;
}

int most_solutions(double alpha, double mu) {
  int most = 0;
  for (const double u_n : {-1.0, 1.0}) {
    for (int i = -160; i <= 160; ++i) {  // u_t to 1e5: just above mu* it takes thousands
      const double u_t = i == 0 ? 0 : std::copysign(std::pow(10.0, std::abs(i) / 20.0 - 3), i);
      const auto k = leaning_corner(alpha, u_n, u_t, mu);
      most = std::max(most, int(all_solutions(k).size()));
    }
  }
  return most;
}

// A square of mass 1 on the ground, one of mass R on it: normal rows of both contacts, friction 0.
GaussSeidel stack(double R, double tolerance) {
  Eigen::Matrix4d G = Eigen::Matrix4d::Identity();
  G(0, 2) = G(2, 0) = -1;
  G(2, 2) = 1 + 1 / R;
  const Eigen::Vector4d u(-0.0981, 0, 0, 0);
  return gauss_seidel(G, u, 0, tolerance, 100'000'000);
}

// The number of pivots of Lemke's method for the same two contacts.
int lemke_pivots(double R) {
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1 + 1 / R;
  const LemkeResult z = lemke(G, Eigen::Vector2d(-0.0981, 0));
  if (!z.is_solved) throw std::logic_error("a stack without a solution");
  return z.pivots;
}

constexpr int kMostSweeps = 10'000;

// The share of one-corner contacts with random arms and velocities that don't converge.
double share_without_end(double mu) {
  Random random(1);
  int endless = 0;
  constexpr int kContacts = 2000;
  for (int i = 0; i < kContacts; ++i) {
    const double u_t = random.uniform(-3, 3), u_n = -random.uniform(0.1, 1);
    const auto k = leaning_corner(random.uniform(-0.78, 0.78), u_n, u_t, mu);
    Eigen::Matrix2d G;
    G << k.a, k.b, k.b, k.c;
    endless += !gauss_seidel(G, Eigen::Vector2d(k.u_n, k.u_t), mu, 1e-9, kMostSweeps).converged;
  }
  return double(endless) / kContacts;
}

// How deep the lowest corner gets in the first steps: the maximum over starts whose heights are
// spread evenly over the fall of one step, so that no method is lucky.
template <class Scheme>
double deepest(double speed, double dt) {
  const Parameters params{.dt = dt};
  const Scheme scheme(params);
  double depth = 0;
  constexpr int kHeights = 256;
  for (int start = 0; start < kHeights; ++start) {
    const double above = params.delta + 1e-9 + speed * dt * start / kHeights;
    const Motion<double> s{0, scheme.rho + above, std::numbers::pi / 4, 0, -speed, 0};
    for (const auto& moved : sample(scheme, s, 4, 1))
      depth = std::max(depth, -lowest_gap(moved, scheme));
  }
  return depth;
}

struct Residuals {
  double lemke;   // residual of the 8x8 if Lemke says "solved", m/s
  double merged;  // residual of the merged problem, m/s
  int wrong;      // how often Lemke says "solved" with a residual above 1e-6
};

// The residual of impulses in the merged problem, m/s: the distance from p to the projection of p -
// (w, v_t) onto the allowed impulses. 0 for a solution, and for nothing else.
double residual_of(const TwoCorners<double>& k, const SideImpulse<double>& p) {
  const double friction = k.mu * (p.n[0] + p.n[1]);
  const double v_t = k.b(0) * p.n[0] + k.b(1) * p.n[1] + k.c() * p.t + k.u_t;
  double worst = std::abs(p.t - std::clamp(p.t - v_t, -friction, friction));
  for (int i = 0; i < 2; ++i) {
    const double w = k.A(i, 0) * p.n[0] + k.A(i, 1) * p.n[1] + k.b(i) * p.t + k.u[i];
    worst = std::max(worst, std::abs(std::min(p.n[i], w)));
  }
  return worst;
}

// The worst residuals over random velocities, of a square turned by theta to 1.8 theta with both
// low corners in contact.
Residuals residuals_at(double theta) {
  const Parameters params;
  Random random(1);
  const auto uniform = [&] { return random.uniform(-2, 2); };
  Residuals worst{};
  for (int i = 0; i < 4000; ++i) {
    const double turned = theta * std::pow(10.0, (uniform() + 2) / 16);
    const auto r = arms(params.l / 2, std::cos(turned), std::sin(turned));
    const Vector3 v(uniform(), uniform() - 2, 10 * uniform());
    const Lcp8 lcp = form_lcp8(r[2], r[3], v, params);
    const LemkeResult z = lemke(lcp.V, lcp.p);
    const double left = lcp_residual(lcp.V, lcp.p, z.z);
    if (z.is_solved) worst.lemke = std::max(worst.lemke, left);
    worst.wrong += z.is_solved && !(left <= 1e-6);
    const auto side = two_corners<double>(r[2], r[3], params.l * params.l / 6, {lcp.p(0), lcp.p(4)},
                                          (lcp.p(2) + lcp.p(6)) / 2, params.mu);
    const auto p = solve_two_corners(side);
    worst.merged = std::max(worst.merged, residual_of(side, p));
  }
  return worst;
}

constexpr double kDrop = 0.2;      // m that the centre falls until a flat face lands
constexpr double kStep = 1e-4;     // s
constexpr double kLooking = 0.21;  // s; the face lands at 0.202 s, and again only at 0.4 s

template <class Scheme>
double turning(double theta) {
  const Parameters params{.dt = kStep};
  const Motion<double> start{0, params.l / 2 + kDrop, theta, 0, 0, 0};
  return sample(Scheme(params), start, 1, std::lround(kLooking / kStep)).back().omega;
}

double true_turning(double theta) {
  const Parameters params;
  const Motion<double> start{0, params.l / 2 + kDrop, theta, 0, 0, 0};
  return simulate_events<double>(params, start, {kLooking}, {}).at(0).omega;
}

}  // namespace

Table energy_gain(const Scenes&, const Extent&) {
  Table table({"mu", "epsilon", "newton", "poisson", "stronge", "limit_epsilon"});
  constexpr int n = 20;
  for (int i = 0; i <= 6 * n / 5; ++i) {
    const double mu = double(i) / n, limit = least_limit(mu);
    for (int j = 0; j <= n; ++j) {
      const auto gain = [&](ImpactLaw law) { return largest_gain(law, mu, double(j) / n); };
      table.add(mu, double(j) / n, gain(ImpactLaw::newton), gain(ImpactLaw::poisson),
                gain(ImpactLaw::stronge), limit);
    }
  }
  return table;
}

Table solution_count(const Scenes&, const Extent&) {
  Table table({"alpha_rad", "mu", "most_solutions", "mu_star"});
  constexpr int n = 10;
  for (int i = 1; i < 3 * n; ++i) {
    const double alpha = i * std::numbers::pi / (6 * n);
    const auto k = leaning_corner(alpha, 0, 0, 0);
    const double mu_star = k.a / std::abs(k.b);
    for (int j = 0; j <= 2 * n; ++j)
      table.add(alpha, 2.0 * j / n, most_solutions(alpha, 2.0 * j / n), mu_star);
  }
  return table;
}

Table gauss_seidel_sweeps(const Scenes&, const Extent&) {
  Table table(
      {"problem", "value", "sweeps", "predicted_sweeps", "lemke_pivots", "share_without_end"});
  const std::string kNone;
  constexpr double kTolerance = 1e-9;
  for (double R = 0.01; R < 2e4; R *= std::sqrt(10.0)) {
    const double rate = R / (1 + R);
    table.add("mass_ratio", R, stack(R, kTolerance).sweeps,
              1 + std::log(kTolerance / 0.0981) / std::log(rate), lemke_pivots(R), kNone);
  }
  for (int i = 0; i <= 30; ++i)
    table.add("one_corner_mu", i / 10.0, kNone, kNone, kNone, share_without_end(i / 10.0));
  return table;
}

Table depth(const Scenes&, const Extent&) {
  Table table({"method", "speed_m_s", "dt_s", "v_dt_m", "depth_m"});
  for (const double speed : {1.0, 5.0, 20.0, 60.0}) {
    for (const double dt : {0.02, 0.01, 0.003, 0.001, 0.0001}) {
      table.add("assignment", speed, dt, speed * dt, deepest<Assignment>(speed, dt));
      table.add("moreau_jean_2", speed, dt, speed * dt, deepest<MoreauJean<2>>(speed, dt));
    }
  }
  return table;
}

Table almost_flat(const Scenes&, const Extent&) {
  Table table(
      {"theta_rad", "lemke_8x8_residual_m_s", "lemke_8x8_wrong_of_4000", "merged_residual_m_s"});
  for (int i = 1; i <= 64; ++i) {
    const double theta = std::pow(10.0, -i / 4.0);
    const Residuals r = residuals_at(theta);
    table.add(theta, r.lemke, r.wrong, r.merged);
  }
  return table;
}

Table flat_landing(const Scenes&, const Extent&) {
  Table table({"method", "theta_rad", "omega_rad_s"});
  const auto add = [&](const char* name, double (*omega_of)(double)) {
    for (int i = 16; i >= 1; --i) {
      for (const int sign : {-1, 1}) {
        const double theta = sign * std::pow(10.0, -i);
        table.add(name, theta, omega_of(theta));
      }
    }
    table.add(name, 0.0, omega_of(0.0));
  };
  add("assignment", turning<Assignment>);
  add("moreau_jean_1", turning<MoreauJean<1>>);
  add("moreau_jean_2", turning<MoreauJean<2>>);
  add("event_driven", true_turning);
  return table;
}

}  // namespace bounce::study
