#include "formula.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recognise.hpp"

namespace bounce::tests::formula {
namespace {

double r_x(const Asked& a) { return a.right(5); }
double r_y(const Asked& a) { return -a.right(2); }

// How far the middle of the lowest side is below the centre.
double depth_of_the_side(const Asked& a) {
  return l(a) / 2 * std::max(std::abs(std::cos(theta(a))), std::abs(std::sin(theta(a))));
}

const Formulas& heights() {
  static const Formulas all{
      {"0", [](const Asked&) { return 0.0; }},
      {"y, the height of the centre", y},
      {"y - l/2", [](const Asked& a) { return y(a) - l(a) / 2; }},
      {"the height of the middle of the lowest side",
       [](const Asked& a) { return y(a) - depth_of_the_side(a); }},
      {"y - (l/2) |cos(theta)|",
       [](const Asked& a) { return y(a) - l(a) / 2 * std::abs(std::cos(theta(a))); }},
      {"y - (l/sqrt(2)) |cos(theta)|",
       [](const Asked& a) { return y(a) - l(a) / std::sqrt(2) * std::abs(std::cos(theta(a))); }},
      {"y - (l/2) (cos(theta) + sin(theta))",
       [](const Asked& a) { return y(a) - l(a) / 2 * (std::cos(theta(a)) + std::sin(theta(a))); }},
      {"y - l", [](const Asked& a) { return y(a) - l(a); }},
      {"y - l/sqrt(2)", [](const Asked& a) { return y(a) - l(a) / std::sqrt(2); }},
      {"-phi", [](const Asked& a) { return -a.right(6); }},
      {"the absolute value of phi", [](const Asked& a) { return std::abs(a.right(6)); }},
      {"max(0, phi)", [](const Asked& a) { return std::max(0.0, a.right(6)); }},
      {"max(0, -phi)", [](const Asked& a) { return std::max(0.0, -a.right(6)); }},
      {"phi - delta", [](const Asked& a) { return a.right(6) - a.c.params.delta; }},
      {"r_y", r_y},
      {"-r_y", [](const Asked& a) { return -r_y(a); }},
      {"x + r_x, the x of the corner", [](const Asked& a) { return x(a) + r_x(a); }},
      {"x + r_y", [](const Asked& a) { return x(a) + r_y(a); }},
      {"y + r_x", [](const Asked& a) { return y(a) + r_x(a); }},
      {"y - r_y, the height of the highest corner", [](const Asked& a) { return y(a) - r_y(a); }},
      {"y + 2 r_y", [](const Asked& a) { return y(a) + 2 * r_y(a); }}};
  return all;
}

const Formulas& arms() {
  static const Formulas all{
      {"r_x", r_x},
      {"-r_x", [](const Asked& a) { return -r_x(a); }},
      {"r_y", r_y},
      {"-r_y", [](const Asked& a) { return -r_y(a); }},
      {"0", [](const Asked&) { return 0.0; }},
      {"the absolute value of r_x", [](const Asked& a) { return std::abs(r_x(a)); }},
      {"y, the height of the centre", y},
      {"-y", [](const Asked& a) { return -y(a); }},
      {"phi", [](const Asked& a) { return a.right(6); }},
      {"-phi", [](const Asked& a) { return -a.right(6); }},
      {"x + r_x", [](const Asked& a) { return x(a) + r_x(a); }}};
  return all;
}

// J and phi of a square that is turned by another angle, or has another half diagonal.
bool is_corner(const Asked& a, const Vector3& r) {
  return same(a.got(2), -r(1)) && same(a.got(5), r(0)) && same(a.got(6), y(a) + r(1));
}

void add_angle(Words& sentences, const std::vector<Asked>& all) {
  const Formulas angles{
      {"theta / 2", [](const Asked& a) { return theta(a) / 2; }},
      {"2 theta", [](const Asked& a) { return 2 * theta(a); }},
      {"theta + 45 degrees", [](const Asked& a) { return theta(a) + std::numbers::pi / 4; }}};
  for (const Formula& angle : angles) {
    const bool fit = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
      return is_corner(a, lowest_corner(angle.value(a), l(a)));
    });
    if (fit) {
      sentences.push_back("Your answers are those of a square that is turned by " + angle.words +
                          " in every question.");
    }
  }
}

void add_half_diagonal(Words& sentences, const std::vector<Asked>& all) {
  const Formulas lengths{{"1", [](const Asked&) { return 1.0; }},
                         {"l/4", [](const Asked& a) { return l(a) / 4; }},
                         {"sqrt(2) l", [](const Asked& a) { return std::sqrt(2) * l(a); }},
                         {"l^2 / 2", [](const Asked& a) { return l(a) * l(a) / 2; }},
                         {"l^2", [](const Asked& a) { return l(a) * l(a); }}};
  for (const Formula& length : lengths) {
    const bool fit = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
      const double times = length.value(a) / (l(a) / std::sqrt(2));
      return is_corner(a, times * Vector3(r_x(a), r_y(a), 0));
    });
    if (fit) {
      sentences.push_back("Your corner is " + length.words +
                          " away from the centre in every question, where l/sqrt(2) belongs.");
    }
  }
}

bool is_normalised(const std::vector<Asked>& all, Index first) {
  return std::all_of(all.begin(), all.end(), [&](const Asked& a) {
    const Vector3 right = a.right.segment<3>(first).normalized();
    const Vector3 difference = a.got.segment<3>(first) - right;
    return difference.norm() < 1e-9;
  });
}

}  // namespace

Words of_part1(const std::vector<Asked>& all) {
  Words sentences;
  if (is_right(all, 0) && is_right(all, 1) && is_right(all, 3) && is_right(all, 4)) {
    add_angle(sentences, all);
    add_half_diagonal(sentences, all);
  }
  for (const auto& [name, first] : {std::pair("J_t", 0), std::pair("J_n", 3)}) {
    if (!is_right(all, first + 2) && is_normalised(all, first)) {
      sentences.push_back("Your " + std::string(name) + " has the length 1 in every question.");
    }
  }
  if (!is_right(all, 6)) add(sentences, "Your phi", fitting(heights(), all, entry(6)));
  const auto wrong_arm = [&](const std::string& name, Index i, const std::string& due) {
    const std::string formula = is_right(all, i) ? "" : fitting(arms(), all, entry(i));
    if (!formula.empty()) {
      sentences.push_back("The third entry of your " + name + " is " + formula +
                          " in every question, where " + due + " belongs.");
    }
  };
  if (is_right(all, 0)) wrong_arm("J_t", 2, "-r_y");
  if (is_right(all, 4)) wrong_arm("J_n", 5, "r_x");
  return sentences;
}

}  // namespace bounce::tests::formula
