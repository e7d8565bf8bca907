#include "formula.hpp"

#include <algorithm>
#include <cmath>

#include "recognise.hpp"

namespace bounce::tests::formula {
namespace {

bool fits(const Formula& formula, const std::vector<Asked>& all,
          const std::function<double(const Asked&)>& number) {
  return all.size() >= kEnough && std::all_of(all.begin(), all.end(), [&](const Asked& asked) {
           return same(formula.value(asked), number(asked));
         });
}

}  // namespace

std::string fitting(const Formulas& formulas, const std::vector<Asked>& all,
                    const std::function<double(const Asked&)>& number) {
  Words words;
  for (const Formula& formula : formulas) {
    if (fits(formula, all, number)) words.push_back(formula.words);
  }
  if (words.size() > 2) return "";
  return words.size() == 2 ? "either " + words[0] + " or " + words[1] : joined(words);
}

std::function<double(const Asked&)> entry(Index i) {
  return [i](const Asked& asked) { return asked.got(i); };
}

bool is_right(const std::vector<Asked>& all, Index i) {
  return std::all_of(all.begin(), all.end(),
                     [&](const Asked& asked) { return same(asked.got(i), asked.right(i)); });
}

void add(Words& sentences, const std::string& subject, const std::string& formula) {
  if (!formula.empty()) sentences.push_back(subject + " is " + formula + " in every question.");
}

double x(const Asked& a) { return a.c.q(0); }
double y(const Asked& a) { return a.c.q(1); }
double theta(const Asked& a) { return a.c.q(2); }
double l(const Asked& a) { return a.c.params.l; }

Vector3 lowest_corner(double angle, double side) {
  const double c = std::cos(angle) * side / 2, s = std::sin(angle) * side / 2;
  // Down is along -c for one pair of sides and along -s for the other.
  const double along = s < 0 ? 1 : -1, aside = c < 0 ? 1 : -1;
  return {along * c - aside * s, along * s + aside * c, 0};
}

bool same_vector(const Vector3& a, const Vector3& b) {
  return same(a(0), b(0)) && same(a(1), b(1)) && same(a(2), b(2));
}

}  // namespace bounce::tests::formula
