#include <algorithm>
#include <cmath>
#include <numbers>

#include "formula.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

constexpr Eigen::Index kPhi = 6;

std::vector<Value> heights(const Asked& a) {
  const double x = a.c.q(0), y = a.c.q(1), l = a.c.params.l, phi = a.right(kPhi);
  const double r_x = a.right(5), r_y = -a.right(2);
  const double c = std::cos(a.c.q(2)), s = std::sin(a.c.q(2));
  return {{"0", 0},
          {"y, the height of the centre", y},
          {"y - l/2", y - l / 2},
          {"the height of the middle of the lowest side",
           y - l / 2 * std::max(std::abs(c), std::abs(s))},
          {"y - (l/2) |cos(theta)|", y - l / 2 * std::abs(c)},
          {"y - (l/sqrt(2)) |cos(theta)|", y - l / std::sqrt(2) * std::abs(c)},
          {"y - (l/2) (cos(theta) + sin(theta))", y - l / 2 * (c + s)},
          {"y - l", y - l},
          {"y - l/sqrt(2)", y - l / std::sqrt(2)},
          {"-phi", -phi},
          {"the absolute value of phi", std::abs(phi)},
          {"max(0, phi)", std::max(0.0, phi)},
          {"max(0, -phi)", std::max(0.0, -phi)},
          {"min(delta, phi)", std::min(a.c.params.delta, phi)},
          {"min(l, phi)", std::min(l, phi)},
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

// --- other squares ---

std::vector<Value> angles(const Asked& a) {
  const double theta = a.c.q(2);
  return {{"theta / 2", theta / 2},
          {"2 theta", 2 * theta},
          {"theta + 45 degrees", theta + std::numbers::pi / 4}};
}

std::vector<Value> half_diagonals(const Asked& a) {
  const double l = a.c.params.l;
  return {{"1", 1},
          {"l/4", l / 4},
          {"sqrt(2) l", std::sqrt(2) * l},
          {"l^2 / 2", l * l / 2},
          {"l^2", l * l}};
}

// Whether the third entries of J and phi are those of this corner.
bool is_of(const Asked& a, const Corner& r) {
  return same(a.got(2), -r.y) && same(a.got(5), r.x) && same(a.got(kPhi), a.c.q(1) + r.y);
}

void add_angle(Words& sentences, const std::vector<Asked>& all) {
  for (const Formula& angle : in_all(all, angles)) {
    std::size_t k = 0;
    while (k < all.size() && is_of(all[k], lowest_corner(angle.values[k], all[k].c.params.l))) ++k;
    if (k == all.size()) {
      sentences.push_back("Your answers are those of a square that is turned by " + angle.words +
                          " in every question.");
    }
  }
}

void add_half_diagonal(Words& sentences, const std::vector<Asked>& all) {
  for (const Formula& length : in_all(all, half_diagonals)) {
    const auto corner = [&](std::size_t k) {
      const double times = length.values[k] / (all[k].c.params.l / std::sqrt(2));
      return Corner{times * all[k].right(5), -times * all[k].right(2)};
    };
    std::size_t k = 0;
    while (k < all.size() && is_of(all[k], corner(k))) ++k;
    if (k == all.size()) {
      sentences.push_back("Your corner is " + length.words +
                          " away from the centre in every question, where l/sqrt(2) belongs.");
    }
  }
}

// Whether a column of J, whose first entry this is, is the right one divided by its length.
bool is_normalised(const std::vector<Asked>& all, Eigen::Index first) {
  return std::all_of(all.begin(), all.end(), [&](const Asked& a) {
    double length = 0, difference = 0;
    for (Eigen::Index i = first; i < first + 3; ++i) length = std::hypot(length, a.right(i));
    for (Eigen::Index i = first; i < first + 3; ++i)
      difference = std::hypot(difference, a.got(i) - a.right(i) / length);
    return difference < 1e-9;
  });
}

void add_length(Words& sentences, const std::vector<Asked>& all, const std::string& column,
                Eigen::Index first) {
  if (!is_right(all, first + 2) && is_normalised(all, first))
    sentences.push_back("Your " + column + " has the length 1 in every question.");
}

}  // namespace

Words formulas_of_part1(const std::vector<Asked>& all) {
  Words sentences;
  if (is_right(all, 0) && is_right(all, 1) && is_right(all, 3) && is_right(all, 4)) {
    add_angle(sentences, all);
    add_half_diagonal(sentences, all);
  }
  add_length(sentences, all, "J_t", 0);
  add_length(sentences, all, "J_n", 3);
  if (!is_right(all, kPhi)) {
    const std::string formula = fitting(in_all(all, heights), entry(all, kPhi));
    add_formula(sentences, "Your phi", formula);
    if (formula.empty()) add_bounds(sentences, "phi", right_entry(all, kPhi), entry(all, kPhi));
  }
  if (is_right(all, 0)) add_arm(sentences, all, "J_t", 2, "-r_y");
  if (is_right(all, 4)) add_arm(sentences, all, "J_n", 5, "r_x");
  return sentences;
}

}  // namespace bounce::tests
