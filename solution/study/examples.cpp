#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "../methods/impact_laws.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

using methods::Arm;
using methods::ImpactLaw;

// Kane's paradox: the energy after the impact over that before.
double kane(ImpactLaw law) {
  const Parameters params{.epsilon = 0.9, .g = {0, 0, 0}};
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
    const auto k = methods::leaning_corner(alpha, 0, 0, 0);
    if (value(k) < least.value) least = {value(k), std::tan(alpha)};
  }
  return least;
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
  const auto found =
      methods::all_solutions(methods::leaning_corner(std::atan(0.5), kApproach, kSliding, kMu));
  std::vector<double> impulses;
  impulses.reserve(std::size_t(found.count));
  for (int i = 0; i < found.count; ++i) impulses.push_back(found.all[i].n);
  std::sort(impulses.begin(), impulses.end());
  table.add("painleve", "mu", kMu, "none");
  table.add("painleve", "p_1", kApproach, "m/s");
  table.add("painleve", "v_t", kSliding, "m/s");
  table.add("painleve", "solutions", found.count, "none");
  for (const double impulse : impulses) table.add("painleve", "f_n dt / m", impulse, "m/s");
  return table;
}

}  // namespace bounce::study
