#include "formula.hpp"

#include <algorithm>
#include <cmath>

#include "recognise.hpp"

namespace bounce::tests {

std::vector<Formula> in_all(const std::vector<Asked>& all,
                            std::vector<Value> (*in_one)(const Asked&)) {
  std::vector<Formula> formulas;
  for (const Asked& asked : all) {
    const std::vector<Value> values = in_one(asked);
    formulas.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      formulas[i].words = values[i].words;
      formulas[i].values.push_back(values[i].value);
    }
  }
  return formulas;
}

std::vector<double> entry(const std::vector<Asked>& all, Eigen::Index i) {
  std::vector<double> numbers;
  for (const Asked& asked : all) numbers.push_back(asked.got(i));
  return numbers;
}

std::vector<double> right_entry(const std::vector<Asked>& all, Eigen::Index i) {
  std::vector<double> numbers;
  for (const Asked& asked : all) numbers.push_back(asked.right(i));
  return numbers;
}

bool is_right(const std::vector<Asked>& all, Eigen::Index i) {
  for (const Asked& asked : all) {
    if (!same(asked.got(i), asked.right(i))) return false;
  }
  return true;
}

std::string fitting(const std::vector<Formula>& formulas, const std::vector<double>& numbers) {
  if (numbers.size() < kEnough) return "";
  Words words;
  for (const Formula& formula : formulas) {
    std::size_t k = 0;
    while (k < numbers.size() && same(formula.values[k], numbers[k])) ++k;
    if (k == numbers.size()) words.push_back(formula.words);
  }
  if (words.size() > 2) return "";
  return words.size() == 2 ? "either " + words[0] + " or " + words[1] : joined(words);
}

void add_formula(Words& sentences, const std::string& subject, const std::string& formula) {
  if (!formula.empty()) sentences.push_back(subject + " is " + formula + " in every question.");
}

std::string product(const std::string& factor, const std::string& of) {
  return factor == "0" ? factor : factor + of;
}

std::string sum(const std::string& a, const std::string& b) {
  if (b == "0") return a;
  if (a == "0") return b;
  return b[0] == '-' ? a + " - " + b.substr(1) : a + " + " + b;
}

void add_bounds(Words& sentences, const std::string& name, const std::vector<double>& right,
                const std::vector<double>& got) {
  double least = -INFINITY, most = INFINITY;
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < got.size(); ++k) {
    if (same(got[k], right[k])) continue;
    (got[k] > right[k] ? least : most) = got[k];
    ++wrong;
  }
  if (wrong < kEnough || got.size() - wrong < kEnough) return;
  for (std::size_t k = 0; k < got.size(); ++k)
    if (!same(got[k], std::min(std::max(right[k], least), most))) return;
  std::string words = name;
  if (std::isfinite(least)) words = "max(" + digits(least) + ", " + words + ")";
  if (std::isfinite(most)) words = "min(" + digits(most) + ", " + words + ")";
  add_formula(sentences, "Your " + name, words);
}

Corner lowest_corner(double angle, double side) {
  const double c = std::cos(angle) * side / 2, s = std::sin(angle) * side / 2;
  // Down is along -c for one pair of sides and along -s for the other.
  const double along = s < 0 ? 1 : -1, aside = c < 0 ? 1 : -1;
  return {along * c - aside * s, along * s + aside * c};
}

}  // namespace bounce::tests
