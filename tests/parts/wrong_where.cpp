#include "wrong_where.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "wrong_numbers.hpp"

namespace bounce::tests {
namespace {

// What may be true of a case; the words follow "where".
struct Trait {
  const char* words;
  bool has;
};

using Traits = std::vector<Trait>;

Traits other_parameters(const Case& c) {
  const Parameters &p = c.params, usual;
  return {{"l", p.l != usual.l},
          {"m", p.m != usual.m},
          {"mu", p.mu != usual.mu},
          {"epsilon", p.epsilon != usual.epsilon},
          {"g", p.g != usual.g},
          {"dt", p.dt != usual.dt},
          {"delta", p.delta != usual.delta}};
}

Traits gravity_sideways(const Case& c) { return {{"gravity has an x part", c.params.g(0) != 0}}; }

Traits what_the_corner_does(const Case& c) {
  const auto says = [&](const char* words) { return c.corner.find(words) != std::string::npos; };
  return {{"corner 1 is the lowest", says("corner 1")},
          {"corner 1 is not the lowest", !says("corner 1")},
          {"corner 2 is the lowest", says("corner 2")},
          {"corner 2 is not the lowest", !says("corner 2")},
          {"corner 3 is the lowest", says("corner 3")},
          {"corner 3 is not the lowest", !says("corner 3")},
          {"corner 4 is the lowest", says("corner 4")},
          {"corner 4 is not the lowest", !says("corner 4")},
          {"the corner slides", says("slides")},
          {"the corner slides to the right", says("slides to the right")},
          {"the corner slides to the left", says("slides to the left")},
          {"the corner sticks", says("sticks")},
          {"the corner leaves the ground", says("leaves the ground")},
          {"no corner touches", says("no corner touches")},
          {"a corner touches", says("touches") && c.corner.rfind("no ", 0) != 0}};
}

Traits corner_and_velocity(const Case& c) {
  Traits traits = what_the_corner_does(c);
  const double v_t = c.J.col(0).dot(c.v), v_n = c.J.col(1).dot(c.v);
  traits.push_back({"the corner slides to the right before the step", v_t > 0});
  traits.push_back({"the corner slides to the left before the step", v_t < 0});
  traits.push_back({"the corner comes down before the step", v_n < 0});
  traits.push_back({"the first two rows of J aren't (1, 0) and (0, 1), as in an arbitrary J",
                    !c.J.topRows<2>().isIdentity(0)});
  return traits;
}

Traits corner_and_angle(const Case& c) {
  Traits traits = what_the_corner_does(c);
  traits.push_back({"theta is negative", c.q(2) < 0});
  traits.push_back({"theta is more than a turn", std::abs(c.q(2)) > 2 * std::numbers::pi});
  return traits;
}

bool includes(const std::set<std::size_t>& all, const std::set<std::size_t>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

// The traits that fit best: those that the fewest right cases have.
struct Fit {
  Words words;
  std::set<std::size_t> cases;
};

std::optional<Fit> closest(Traits (*traits_of)(const Case&), const std::vector<Case>& cases,
                           const std::set<std::size_t>& wrong) {
  std::vector<Fit> fits;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Traits traits = traits_of(cases[k]);
    fits.resize(traits.size());
    for (std::size_t i = 0; i < traits.size(); ++i) {
      fits[i].words = {traits[i].words};
      if (traits[i].has) fits[i].cases.insert(k);
    }
  }
  std::optional<Fit> best;
  for (const Fit& fit : fits) {
    if (!includes(fit.cases, wrong) || fit.cases.size() == cases.size()) continue;
    if (best && fit.cases == best->cases) {
      best->words.push_back(fit.words.front());
    } else if (!best || fit.cases.size() < best->cases.size()) {
      best = fit;
    }
  }
  return best;
}

std::string out_of(const Fit& fit, const std::set<std::size_t>& wrong) {
  const auto all = std::to_string(fit.cases.size()), some = std::to_string(wrong.size());
  return fit.cases.size() == wrong.size() ? "in all " + all + " such cases"
                                          : "in " + some + " of " + all + " such cases";
}

bool are_nearly_all(const std::set<std::size_t>& wrong, const std::set<std::size_t>& cases) {
  return 4 * wrong.size() >= 3 * cases.size();
}

// Tried first: it is a better explanation than a parameter that isn't the assignment's.
std::string where_gravity_is_not_vertical(const std::vector<Case>& cases,
                                          const std::set<std::size_t>& wrong) {
  const auto fit = closest(gravity_sideways, cases, wrong);
  if (!fit || !are_nearly_all(wrong, fit->cases)) return "";
  return "Wrong only where " + fit->words.front() + ", " + out_of(*fit, wrong) + ".";
}

}  // namespace

// Empty if few cases are right: a trait that separates only these may be chance.
std::string where(int part, const std::vector<Case>& cases, const std::set<std::size_t>& wrong) {
  if (wrong.empty() || cases.size() - wrong.size() < kEnough) return "";
  const std::string sideways = where_gravity_is_not_vertical(cases, wrong);
  if (!sideways.empty()) return sideways;
  const auto numbers = closest(other_parameters, cases, wrong);
  const auto traits = closest(part == 2 ? corner_and_velocity : corner_and_angle, cases, wrong);
  if (numbers && are_nearly_all(wrong, numbers->cases) &&
      (!traits || numbers->cases.size() <= traits->cases.size())) {
    return "Wrong only where " + joined(numbers->words, " or ") +
           (numbers->words.size() > 1 ? " aren't" : " isn't") + " the assignment's, " +
           out_of(*numbers, wrong) + ".";
  }
  if (!traits || !are_nearly_all(wrong, traits->cases)) return "";
  return "Wrong only where " + traits->words.front() + ", " + out_of(*traits, wrong) + ".";
}

}  // namespace bounce::tests
