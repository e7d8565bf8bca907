#include <algorithm>
#include <cmath>

#include "formula.hpp"

namespace bounce::tests {
namespace {

constexpr Eigen::Index kPhi = 6;

std::vector<Value> heights(const Asked& a) {
  const double x = a.c.q(0), y = a.c.q(1), l = a.c.params.l, phi = a.right(kPhi);
  const double r_x = a.right(5), r_y = -a.right(2);
  return {{"0", 0},
          {"y, the height of the centre", y},
          {"y - l/2", y - l / 2},
          {"y - l", y - l},
          {"y - l/sqrt(2)", y - l / std::sqrt(2)},
          {"-phi", -phi},
          {"the absolute value of phi", std::abs(phi)},
          {"max(0, phi)", std::max(0.0, phi)},
          {"max(0, -phi)", std::max(0.0, -phi)},
          {"phi - delta", phi - a.c.params.delta},
          {"r_y", r_y},
          {"-r_y", -r_y},
          {"x + r_x, the x of the corner", x + r_x},
          {"x + r_y", x + r_y},
          {"y + r_x", y + r_x},
          {"y - r_y, the height of the highest corner", y - r_y},
          {"y + 2 r_y", y + 2 * r_y}};
}

std::vector<Value> arms(const Asked& a) {
  const double y = a.c.q(1), phi = a.right(kPhi), r_x = a.right(5), r_y = -a.right(2);
  return {{"r_x", r_x},
          {"-r_x", -r_x},
          {"r_y", r_y},
          {"-r_y", -r_y},
          {"0", 0},
          {"the absolute value of r_x", std::abs(r_x)},
          {"y, the height of the centre", y},
          {"-y", -y},
          {"phi", phi},
          {"-phi", -phi},
          {"x + r_x", a.c.q(0) + r_x}};
}

void add_arm(Words& sentences, const std::vector<Asked>& all, const std::string& column,
             Eigen::Index i, const std::string& due) {
  const std::string formula = is_right(all, i) ? "" : fitting(in_all(all, arms), entry(all, i));
  if (formula.empty()) return;
  sentences.push_back("The third entry of your " + column + " is " + formula +
                      " in every question, where " + due + " belongs.");
}

}  // namespace

Words formulas_of_part1(const std::vector<Asked>& all) {
  Words sentences;
  if (!is_right(all, kPhi)) {
    add_formula(sentences, "Your phi", fitting(in_all(all, heights), entry(all, kPhi)));
  }
  if (is_right(all, 0)) add_arm(sentences, all, "J_t", 2, "-r_y");
  if (is_right(all, 4)) add_arm(sentences, all, "J_n", 5, "r_x");
  return sentences;
}

}  // namespace bounce::tests
