// Tools to find formulas that a part's wrong answers follow.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wrong_numbers.hpp"

namespace bounce::tests::formula {

using Eigen::Index;
using Numbers = Eigen::VectorXd;

// A question, its right answer and the part's, in numbers.
struct Asked {
  const Case& c;
  const Numbers &right, &got;
};

struct Formula {
  std::string words;
  std::function<double(const Asked&)> value;
};

using Formulas = std::vector<Formula>;

// What a term is multiplied by.
struct Factor {
  std::string words;
  std::function<double(const Case&)> value;
};

// The words of the formulas that fit: "a", or "either a or b". Empty if none or more do.
std::string fitting(const Formulas& formulas, const std::vector<Asked>& all,
                    const std::function<double(const Asked&)>& number);

// The i-th number of the part's answer.
std::function<double(const Asked&)> entry(Index i);

// Whether the i-th number is right in all answers.
bool is_right(const std::vector<Asked>& all, Index i);

// Adds "SUBJECT is FORMULA in every question.", unless the formula is empty.
void add(Words& sentences, const std::string& subject, const std::string& formula);

double x(const Asked& a);
double y(const Asked& a);
double theta(const Asked& a);
double l(const Asked& a);

// From the centre of a square to its lowest corner.
Vector3 lowest_corner(double angle, double side);

bool same_vector(const Vector3& a, const Vector3& b);

// What the formulas say of each part's answers; of v', in questions in which a corner touches and
// in others.
Words of_part1(const std::vector<Asked>& all);
Words of_part2(const std::vector<Asked>& all);
Words of_part3(const std::vector<Asked>& all);
Words of_part4(const std::vector<Asked>& all);
Words of_new_velocity(const std::vector<Asked>& touching, const std::vector<Asked>& flying);

}  // namespace bounce::tests::formula
