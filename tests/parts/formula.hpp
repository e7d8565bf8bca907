// Which formulas a part's wrong answers follow: shared by the files that list a part's formulas.
#pragma once

#include "wrong_numbers.hpp"

namespace bounce::tests {

// A question, its right answer and the part's, in numbers.
struct Asked {
  const Case& c;
  const Eigen::VectorXd &right, &got;
};

// A formula, and its values in all questions.
struct Formula {
  std::string words;
  std::vector<double> values;
};

// These formulas in all questions, of their values in one.
std::vector<Formula> in_all(const std::vector<Asked>& all,
                            std::vector<Value> (*in_one)(const Asked&));

// The part's entry i in all questions, and the right one.
std::vector<double> entry(const std::vector<Asked>& all, Eigen::Index i);
std::vector<double> right_entry(const std::vector<Asked>& all, Eigen::Index i);

// Whether that entry is right in all questions.
bool is_right(const std::vector<Asked>& all, Eigen::Index i);

// The words of the formulas that give these numbers: "a", or "either a or b". Empty if none or more
// do, or if so few questions may agree by chance.
std::string fitting(const std::vector<Formula>& formulas, const std::vector<double>& numbers);

// Adds "SUBJECT is FORMULA in every question."; nothing if there is no formula.
void add_formula(Words& sentences, const std::string& subject, const std::string& formula);

// "2 v", or "0"; and "2 v - dt M^-1 f_e", in which a "0" is left out.
std::string product(const std::string& factor, const std::string& of);
std::string sum(const std::string& a, const std::string& b);

// Adds "Your phi is min(1, phi) in every question.": a number of the answers, by its name, that is
// right between two bounds, and one of them elsewhere.
void add_bounds(Words& sentences, const std::string& name, const std::vector<double>& right,
                const std::vector<double>& got);

// From the centre of a square to its lowest corner: x and y.
struct Corner {
  double x, y;
};
Corner lowest_corner(double angle, double side);

// What the answers of a part follow, in sentences; of v', in questions in which a corner touches
// and in others.
Words formulas_of_part1(const std::vector<Asked>& all);
Words formulas_of_part2(const std::vector<Asked>& all);
Words formulas_of_part3(const std::vector<Asked>& all);
Words formulas_of_part4(const std::vector<Asked>& all);
Words formulas_of_new_velocity(const std::vector<Asked>& touching,
                               const std::vector<Asked>& flying);

}  // namespace bounce::tests
