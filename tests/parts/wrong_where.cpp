#include "wrong_where.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "wrong_numbers.hpp"

namespace bounce::tests {
namespace {

// A property that some cases have and others don't.
struct Trait {
  std::string words;  // follows "where"
  std::function<bool(const Case&)> has;
};

void add_parameters(std::vector<Trait>& traits) {
  const auto other = [&](const std::string& name, auto member) {
    traits.push_back(
        {name, [member](const Case& c) { return c.params.*member != Parameters().*member; }});
  };
  other("l", &Parameters::l);
  other("m", &Parameters::m);
  other("mu", &Parameters::mu);
  other("epsilon", &Parameters::epsilon);
  other("g", &Parameters::g);
  other("dt", &Parameters::dt);
  other("delta", &Parameters::delta);
}

Trait saying(const std::string& words) {
  return {words, [words](const Case& c) { return c.corner.find(words) != std::string::npos; }};
}

Trait not_saying(const std::string& corner) {
  return {corner + " is not the lowest",
          [corner](const Case& c) { return c.corner.find(corner) == std::string::npos; }};
}

void add_what_the_corner_does(std::vector<Trait>& traits) {
  for (const char* corner : {"corner 1", "corner 2", "corner 3", "corner 4"}) {
    traits.push_back({corner + std::string(" is the lowest"), saying(corner).has});
    traits.push_back(not_saying(corner));
  }
  for (const char* mode : {"slides", "slides to the right", "slides to the left", "sticks",
                           "leaves the ground", "no corner touches"}) {
    traits.push_back(saying(mode));
    if (mode[0] != 'n') traits.back().words = "the corner " + traits.back().words;
  }
  traits.push_back({"a corner touches", [](const Case& c) {
                      return c.corner.find("touches") != std::string::npos &&
                             c.corner.rfind("no ", 0) != 0;
                    }});
}

void add_motion(int part, std::vector<Trait>& traits) {
  if (part == 2) {
    traits.push_back({"the corner slides to the right before the step",
                      [](const Case& c) { return c.J.col(0).dot(c.v) > 0; }});
    traits.push_back({"the corner slides to the left before the step",
                      [](const Case& c) { return c.J.col(0).dot(c.v) < 0; }});
    traits.push_back({"the corner comes down before the step",
                      [](const Case& c) { return c.J.col(1).dot(c.v) < 0; }});
    return;
  }
  traits.push_back({"theta is negative", [](const Case& c) { return c.q(2) < 0; }});
  traits.push_back({"theta is more than a turn",
                    [](const Case& c) { return std::abs(c.q(2)) > 2 * std::numbers::pi; }});
}

std::set<std::size_t> those_with(const Trait& trait, const std::vector<Case>& cases) {
  std::set<std::size_t> found;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (trait.has(cases[k])) found.insert(k);
  }
  return found;
}

bool includes(const std::set<std::size_t>& all, const std::set<std::size_t>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

// The traits that fit best: those that the fewest right cases have.
struct Fit {
  Words words;
  std::set<std::size_t> cases;
};

std::optional<Fit> closest(const std::vector<Trait>& traits, const std::vector<Case>& cases,
                           const std::set<std::size_t>& wrong) {
  std::optional<Fit> best;
  for (const Trait& trait : traits) {
    const auto with = those_with(trait, cases);
    if (!includes(with, wrong) || with.size() == cases.size()) continue;
    if (best && with == best->cases) {
      best->words.push_back(trait.words);
    } else if (!best || with.size() < best->cases.size()) {
      best = Fit{{trait.words}, with};
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
  const Trait sideways{"gravity has an x part", [](const Case& c) { return c.params.g(0) != 0; }};
  const auto fit = closest({sideways}, cases, wrong);
  if (!fit || !are_nearly_all(wrong, fit->cases)) return "";
  return "Wrong only where " + sideways.words + ", " + out_of(*fit, wrong) + ".";
}

}  // namespace

// Empty if few cases are right: a trait that separates only these may be chance.
std::string where(int part, const std::vector<Case>& cases, const std::set<std::size_t>& wrong) {
  if (wrong.empty() || cases.size() - wrong.size() < kEnough) return "";
  const std::string sideways = where_gravity_is_not_vertical(cases, wrong);
  if (!sideways.empty()) return sideways;
  std::vector<Trait> parameters, others;
  add_parameters(parameters);
  add_what_the_corner_does(others);
  add_motion(part, others);
  const auto numbers = closest(parameters, cases, wrong), traits = closest(others, cases, wrong);
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
