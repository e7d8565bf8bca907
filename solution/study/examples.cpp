#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "../exact/event_driven.hpp"
#include "../methods/gauss_seidel.hpp"
#include "../methods/impact_laws.hpp"
#include "../methods/penalty.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

using methods::Arm;
using methods::ImpactLaw;

constexpr double kGyration = 1.0 / 3;  // of a rectangle whose corner is 1 from the centre

methods::OneCorner<double> leaning(double alpha, double u_n, double u_t, double mu) {
  return methods::one_corner<double>({std::sin(alpha), -std::cos(alpha)}, kGyration, u_n, u_t, mu);
}

// Kane's paradox: the energy after the impact over that before.
double kane(ImpactLaw law) {
  Parameters params;
  params.epsilon = 0.9;
  params.g.setZero();
  const methods::Body<double> body(params);
  methods::Motion<double> s{0, 0.104267, 0.043633, 0.040023, -0.396829, 6.313089};
  const Jacobian J = get_contacts(methods::state_of(s).q, params).J;
  const Arm<double> r{J(2, 1), -J(2, 0)};
  const auto k = methods::one_corner<double>(r, body.gyration_squared, 0, 0, body.mu);
  const double before = methods::energy(s, body);
  const auto p =
      methods::impact<double>({k.a, k.b, k.c, methods::normal_velocity(s, r),
                               methods::tangential_velocity(s, r), body.mu, params.epsilon},
                              law);
  methods::apply_impulse(s, r, p.n, p.t, body.gyration_squared);
  return methods::energy(s, body) / before;
}

struct Least {
  double value, tan_alpha;
};

// The least over the angles in which a rectangle can lean.
template <class Value>
Least least_over_angles(const Value& value) {
  Least least{1e300, 0};
  for (int i = 1; i < 20'000; ++i) {
    const double alpha = i * std::numbers::pi / 40'000;
    const auto k = leaning(alpha, 0, 0, 0);
    if (value(k) < least.value) least = {value(k), std::tan(alpha)};
  }
  return least;
}

// Whether a sweep of Gauss-Seidel is defined on the LCP of eqs. (9) and (10).
bool literal_is_defined() {
  const Parameters params;
  const Lcp lcp = form_lcp(get_contacts({0, 0.1, 0.1}, params).J, {0, -1, 0}, params);
  return methods::gauss_seidel_lcp(lcp.V, lcp.p, 1e-9, 100).has_value();
}

// How a square that tips over one corner leaves when the other has struck.
struct Tipped {
  double held, other, omega;  // v_n of both corners, m/s; rad/s
};

// By springs, with a step so small that only their law is left, and as it should be: Newton's law
// for both corners at once.
std::pair<Tipped, Tipped> tipped_square() {
  constexpr int kHeld = 2, kOther = 3;  // of arms(), at the start's angle
  Parameters params;
  params.dt = 1e-6;
  const methods::Body<double> body(params);
  methods::Motion<double> start{0, 0, 0.2, 0, 0, 0};
  start.y = -methods::lowest_gap(start, body);
  const auto of = [&](const methods::Motion<double>& s) -> Tipped {
    const auto r = methods::arms(body, s.theta);
    return {methods::normal_velocity(s, r[kHeld]), methods::normal_velocity(s, r[kOther]), s.omega};
  };
  const auto down = [&](const methods::Motion<double>& s) {
    return s.y + methods::arms(body, s.theta)[kOther].y < 0;
  };
  methods::Penalty springs(params, start);
  double t = 0;
  for (bool struck = false; t < 1 && !(struck && !down(springs.motion())); t += params.dt) {
    springs.steps(1);
    struck = struck || down(springs.motion());
  }
  const auto exact = simulate_events<double>(params, start, {t}, EventOptions());
  return {of(springs.motion()), of(exact.at(0))};
}

}  // namespace

Table examples() {
  Table table({"example", "quantity", "value", "unit"});
  table.add("kane", "energy after / before, Newton", kane(ImpactLaw::newton), "none");
  table.add("kane", "energy after / before, Poisson", kane(ImpactLaw::poisson), "none");
  table.add("kane", "energy after / before, Stronge", kane(ImpactLaw::stronge), "none");
  const Least epsilon =
      least_over_angles([](const auto& k) { return std::sqrt(1 - k.b * k.b / (k.a * k.c)); });
  table.add("rectangle", "least epsilon that can gain", epsilon.value, "none");
  const Least mu = least_over_angles([](const auto& k) { return k.a / std::abs(k.b); });
  table.add("rectangle", "least mu with a <= mu |b|", mu.value, "none");
  table.add("rectangle", "tan alpha there", mu.tan_alpha, "none");
  constexpr double kMu = 2, kApproach = 0.1, kSliding = 1;
  const auto found = methods::all_solutions(leaning(std::atan(0.5), kApproach, kSliding, kMu));
  std::vector<double> impulses;
  impulses.reserve(std::size_t(found.count));
  for (int i = 0; i < found.count; ++i) impulses.push_back(found.all[i].n);
  std::sort(impulses.begin(), impulses.end());
  table.add("painleve", "mu", kMu, "none");
  table.add("painleve", "p_1", kApproach, "m/s");
  table.add("painleve", "v_t", kSliding, "m/s");
  table.add("painleve", "solutions", found.count, "none");
  for (const double impulse : impulses) table.add("painleve", "f_n dt / m", impulse, "m/s");
  table.add("gauss_seidel", "defined on the 4x4 of eq. (9)", literal_is_defined(), "none");
  const auto [springs, exact] = tipped_square();
  for (const auto& [name, tipped] : {std::pair{"springs", springs}, {"Newton", exact}}) {
    const std::string law = std::string(", ") + name;
    table.add("tipped", "v_n of the held corner" + law, tipped.held, "m/s");
    table.add("tipped", "v_n of the other corner" + law, tipped.other, "m/s");
    table.add("tipped", "omega" + law, std::abs(tipped.omega), "rad/s");
  }
  return table;
}

}  // namespace bounce::study
