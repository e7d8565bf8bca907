#include "findings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "expression.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

// What may be true of a case, in words that follow "where".
using Traits = std::vector<std::pair<std::string, bool>>;

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
  const auto says = [&](const std::string& words) { return c.corner.find(words) != words.npos; };
  Traits traits;
  for (const char* corner : {"corner 1", "corner 2", "corner 3", "corner 4"}) {
    traits.push_back({corner + std::string(" is the lowest"), says(corner)});
    traits.push_back({corner + std::string(" is not the lowest"), !says(corner)});
  }
  for (const char* what :
       {"the corner slides", "the corner slides to the right", "the corner slides to the left",
        "the corner sticks", "the corner leaves the ground"}) {
    traits.push_back({what, says(what + 11)});  // without "the corner "
  }
  traits.push_back({"no corner touches", says("no corner touches")});
  traits.push_back({"a corner touches", says("touches") && c.corner.rfind("no ", 0) != 0});
  return traits;
}

Traits corner_and_velocity(const Case& c) {
  Traits traits = what_the_corner_does(c);
  const double v_t = c.J.col(0).dot(c.v), v_n = c.J.col(1).dot(c.v);
  const Traits more{{"the corner slides to the right before the step", v_t > 0},
                    {"the corner slides to the left before the step", v_t < 0},
                    {"the corner comes down before the step", v_n < 0},
                    {"the first two rows of J aren't (1, 0) and (0, 1), as in an arbitrary J",
                     !c.J.topRows<2>().isIdentity(0)}};
  traits.insert(traits.end(), more.begin(), more.end());
  return traits;
}

Traits corner_and_angle(const Case& c) {
  Traits traits = what_the_corner_does(c);
  const double phi = c.q(1) + lowest_corner(c.q(2), c.params.l).y;
  const Traits more{{"phi < 0", phi < 0},
                    {"phi < delta", phi < c.params.delta},
                    {"phi >= delta", phi >= c.params.delta},
                    {"theta is negative", c.q(2) < 0},
                    {"theta is more than a turn", std::abs(c.q(2)) > 2 * std::numbers::pi}};
  traits.insert(traits.end(), more.begin(), more.end());
  return traits;
}

// What the corner of part 3 does, by the right v'.
std::string by_the_right_answer(const Case& c, const Answer& right) {
  const auto r = lowest_corner(c.q(2), c.params.l);
  const double quarters = std::floor(c.q(2) / (std::numbers::pi / 2));
  const int of_a_turn = static_cast<int>(quarters - 4 * std::floor(quarters / 4));
  const std::string corner = "corner " + std::to_string((6 - of_a_turn) % 4 + 1);
  if (c.q(1) + r.y >= c.params.delta) return "no corner touches; " + corner + " is the lowest";
  const Answer v{right.numbers.tail(3), ""}, free{c.v + c.params.dt * c.params.g, ""};
  if (same(v, free)) return corner + " touches and leaves the ground";
  const double v_t = v.numbers(0) - r.y * v.numbers(2);
  return corner + " touches and " +
         (same(v_t, 0) ? "sticks"
          : v_t > 0    ? "slides to the right"
                       : "slides to the left");
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
      fits[i].words = {traits[i].first};
      if (traits[i].second) fits[i].cases.insert(k);
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

std::string only_where(const Fit& fit, const std::string& isnt,
                       const std::set<std::size_t>& wrong) {
  const auto all = std::to_string(fit.cases.size()), some = std::to_string(wrong.size());
  return "Wrong only where " + fit.words.front() + isnt + ", in " +
         (all == some ? "all " + all : some + " of " + all) + " such cases.";
}

bool are_nearly_all(const std::set<std::size_t>& wrong, const std::set<std::size_t>& cases) {
  return 4 * wrong.size() >= 3 * cases.size();
}

}  // namespace

std::vector<Case> named_by_answer(std::vector<Case> cases, const std::vector<Answer>& right) {
  for (std::size_t k = 0; k < cases.size(); ++k)
    cases[k].corner = by_the_right_answer(cases[k], right[k]);
  return cases;
}

// Empty if few cases are right: a trait that separates only these may be chance.
std::string where(int part, const std::vector<Case>& cases, const std::set<std::size_t>& wrong) {
  if (wrong.empty() || cases.size() - wrong.size() < kEnough) return "";
  // Tried first: it is a better explanation than a parameter that isn't the assignment's.
  const auto sideways = closest(gravity_sideways, cases, wrong);
  if (sideways && are_nearly_all(wrong, sideways->cases)) return only_where(*sideways, "", wrong);
  const auto numbers = closest(other_parameters, cases, wrong);
  const auto traits = closest(part == 2 ? corner_and_velocity : corner_and_angle, cases, wrong);
  if (numbers && are_nearly_all(wrong, numbers->cases) &&
      (!traits || numbers->cases.size() <= traits->cases.size())) {
    const bool one = numbers->words.size() == 1;
    return only_where({{joined(numbers->words, " or ")}, numbers->cases},
                      one ? " isn't the assignment's" : " aren't the assignment's", wrong);
  }
  if (!traits || !are_nearly_all(wrong, traits->cases)) return "";
  return only_where(*traits, "", wrong);
}

}  // namespace bounce::tests
