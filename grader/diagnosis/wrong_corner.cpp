#include <cmath>

#include "expression.hpp"
#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

// The four corners, by r, are quarter turns of each other about the centre, counter-clockwise.
Corner turned(Corner r, int quarters) {
  for (int k = 0; k < quarters; ++k) r = {-r.y, r.x};
  return r;
}

Corner lowest(const Answer& right) { return {right.numbers(5), -right.numbers(2)}; }

// How many corners after the lowest one the answer's J and phi belong to; -1 if to none.
struct Taken {
  int J = -1, phi = -1;
};

bool has_its_ones(const Answer& got) {
  return same(got.numbers(0), 1) && same(got.numbers(1), 0) && same(got.numbers(3), 0) &&
         same(got.numbers(4), 1);
}

Taken taken(const Case& c, const Answer& right, const Answer& got) {
  Taken found;
  for (const int quarters : {3, 2, 1, 0}) {
    const Corner r = turned(lowest(right), quarters);
    if (same(got.numbers(2), -r.y) && same(got.numbers(5), r.x)) found.J = quarters;
    if (same(got.numbers(6), c.q(1) + r.y)) found.phi = quarters;
  }
  return has_its_ones(got) ? found : Taken{-1, found.phi};
}

int number_of_lowest(const Case& c) {
  const std::size_t at = c.corner.find("corner ");
  return at == std::string::npos ? 0 : c.corner[at + 7] - '0';
}

// A program may number them otherwise.
const std::string kNumbered = " Corners are numbered as in eq. (3).";

int after(int corner, int quarters) { return (corner - 1 + quarters) % 4 + 1; }

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

// How many corners after the lowest one it is.
int chosen(const Choice& choice, const Case& c, const Corner& r) {
  int best = 0;
  for (const int quarters : {1, 2, 3}) {
    if (choice.least(c, turned(r, quarters)) < choice.least(c, turned(r, best))) best = quarters;
  }
  return best;
}

// The lowest of the other three is the one on the lower side.
int lowest_of_the_others(const Corner& r) { return turned(r, 1).y < turned(r, 3).y ? 1 : 3; }

std::string plural(const std::set<int>& corners) {
  Words numbers;
  for (const int corner : corners) numbers.push_back(std::to_string(corner));
  return (corners.size() == 1 ? "Corner " : "Corners ") + joined(numbers) +
         (corners.size() == 1 ? " is" : " are");
}

}  // namespace

Words corners(const std::vector<Case>& cases, const std::vector<Answer>& right,
              const std::vector<Answer>& got) {
  std::set<int> of_J, of_phi, lowest_ones;
  bool wrong_J = false, wrong_phi = false, phi_is_a_corners = true, one_corner = true;
  bool by_others = true;
  std::set<int> turns;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const int number = number_of_lowest(cases[k]);
    if (!is_finite(right[k], got[k])) return {};
    if (number == 0) continue;
    const Taken t = taken(cases[k], right[k], got[k]);
    if (t.J < 0) return {};
    phi_is_a_corners = phi_is_a_corners && t.phi >= 0;
    one_corner = one_corner && t.J == t.phi;
    wrong_J = wrong_J || t.J != 0;
    wrong_phi = wrong_phi || t.phi != 0;
    turns.insert(t.J);
    by_others = by_others && (t.J == 0 || t.J == lowest_of_the_others(lowest(right[k])));
    of_J.insert(after(number, t.J));
    if (t.phi >= 0) of_phi.insert(after(number, t.phi));
    lowest_ones.insert(number);
  }
  // Always the same quarters further: a formula says that better.
  const bool a_formula = turns.size() == 1 && (!one_corner || *turns.begin() == 2);
  if (!wrong_J || a_formula || lowest_ones.size() < 4) return {};
  const std::string whose = one_corner ? "Your answer" : "Your J";
  if (of_J.size() == 1) {
    return {whose + " is always that of corner " + std::to_string(*of_J.begin()) + "." + kNumbered};
  }
  std::set<int> never;
  for (const int corner : lowest_ones) {
    if (of_J.count(corner) == 0) never.insert(corner);
  }
  if (!never.empty() && one_corner) {
    return {plural(never) + " never chosen, also where " +
            (never.size() == 1 ? "it is the lowest" : "they are the lowest") +
            (by_others && never.size() == 1 ? "; your answer is that of the lowest of the others."
                                            : ".") +
            kNumbered};
  }
  if (one_corner) {
    for (const Choice& choice : kChoices) {
      std::size_t k = 0;
      while (k < cases.size() &&
             (number_of_lowest(cases[k]) == 0 ||
              taken(cases[k], right[k], got[k]).J == chosen(choice, cases[k], lowest(right[k])))) {
        ++k;
      }
      if (k == cases.size())
        return {std::string("Your answer is always that of the ") + choice.words + "."};
    }
    return {"Each answer is that of a corner, but not always of the lowest one."};
  }
  if (!wrong_phi) {
    return {
        "phi is that of the lowest corner, and your J is that of another one in some questions."};
  }
  return {};
}

}  // namespace bounce::tests
