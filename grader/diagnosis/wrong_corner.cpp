#include <algorithm>
#include <cmath>

#include "expression.hpp"
#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

// A program may number them otherwise.
const std::string kNumbered = " Corners are numbered as in eq. (3).";

// The four corners, by r, are quarter turns of each other about the centre, counter-clockwise.
Corner turned(Corner r, int quarters) {
  for (int k = 0; k < quarters; ++k) r = {-r.y, r.x};
  return r;
}

// How many corners after the lowest one J and phi of an answer belong to; -1 if to none.
struct Taken {
  const Case& c;
  Corner lowest;
  int number;  // of the lowest corner
  int J = -1, phi = -1;
  int corner() const { return (number - 1 + J) % 4 + 1; }
};

Taken taken(const Case& c, const Eigen::VectorXd& right, const Eigen::VectorXd& got) {
  Taken found{c, {right(5), -right(2)}, c.corner[c.corner.find("corner ") + 7] - '0'};
  const bool has_ones = same(got(0), 1) && same(got(1), 0) && same(got(3), 0) && same(got(4), 1);
  for (const int quarters : {3, 2, 1, 0}) {
    const Corner r = turned(found.lowest, quarters);
    if (has_ones && same(got(2), -r.y) && same(got(5), r.x)) found.J = quarters;
    if (same(got(6), c.q(1) + r.y)) found.phi = quarters;
  }
  return found;
}

// What may be smallest at the corner that is taken in place of the lowest one.
struct Choice {
  const char* words;
  double (*least)(const Case&, const Corner&);
};

constexpr Choice kChoices[] = {
    {"leftmost corner", [](const Case&, const Corner& r) { return r.x; }},
    {"rightmost corner", [](const Case&, const Corner& r) { return -r.x; }},
    {"corner nearest to y = 0, on either side",
     [](const Case& c, const Corner& r) { return std::abs(c.q(1) + r.y); }},
    {"corner nearest to the world's origin",
     [](const Case& c, const Corner& r) { return std::hypot(c.q(0) + r.x, c.q(1) + r.y); }},
};

bool is_chosen(const Choice& choice, const Taken& t) {
  const auto height = [&](int quarters) { return choice.least(t.c, turned(t.lowest, quarters)); };
  int best = 0;
  for (const int quarters : {1, 2, 3}) {
    if (height(quarters) < height(best)) best = quarters;
  }
  return t.J == best;
}

// Whether it is the lowest of the other three: the one on the lower side.
bool is_lowest_of_the_others(const Taken& t) {
  return t.J == (turned(t.lowest, 1).y < turned(t.lowest, 3).y ? 1 : 3);
}

std::string never_chosen(const Words& never, bool by_others) {
  const bool one = never.size() == 1;
  return (one ? "Corner " : "Corners ") + joined(never) +
         (one ? " is never chosen, also where it is the lowest"
              : " are never chosen, also where they are the lowest") +
         (one && by_others ? "; your answer is that of the lowest of the others." : ".") +
         kNumbered;
}

}  // namespace

Words corners(const Cases& cases, const Answers& right, const Answers& got) {
  std::vector<Taken> all;
  std::set<int> chosen, lowest, turns;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (!is_finite(right[k], got[k])) return {};
    if (cases[k].corner.find("corner ") == std::string::npos) continue;
    all.push_back(taken(cases[k], right[k].numbers, got[k].numbers));
    if (all.back().J < 0) return {};
    chosen.insert(all.back().corner());
    lowest.insert(all.back().number);
    turns.insert(all.back().J);
  }
  const auto each = [&](auto&& holds) { return std::all_of(all.begin(), all.end(), holds); };
  const bool one_corner = each([](const Taken& t) { return t.J == t.phi; });
  // Always the same quarters further: a formula says that better.
  const bool a_formula = turns.size() == 1 && (!one_corner || turns.count(2) > 0);
  if (turns == std::set<int>{0} || a_formula || lowest.size() < 4) return {};
  if (chosen.size() == 1) {
    return {(one_corner ? "Your answer" : "Your J") + std::string(" is always that of corner ") +
            std::to_string(*chosen.begin()) + "." + kNumbered};
  }
  if (!one_corner) {
    if (!each([](const Taken& t) { return t.phi == 0; })) return {};
    return {
        "phi is that of the lowest corner, and your J is that of another one in some questions."};
  }
  Words never;
  for (const int corner : lowest) {
    if (chosen.count(corner) == 0) never.push_back(std::to_string(corner));
  }
  if (!never.empty()) {
    return {never_chosen(
        never, each([](const Taken& t) { return t.J == 0 || is_lowest_of_the_others(t); }))};
  }
  for (const Choice& choice : kChoices) {
    if (each([&](const Taken& t) { return is_chosen(choice, t); }))
      return {std::string("Your answer is always that of the ") + choice.words + "."};
  }
  return {"Each answer is that of a corner, but not always of the lowest one."};
}

}  // namespace bounce::tests
