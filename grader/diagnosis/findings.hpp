// What is found in a part's wrong answers: one kind of finding a file. Each gives facts that are
// true of all answers, or none.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "answers.hpp"
#include "tables.hpp"

namespace bounce::tests {

using Answers = std::vector<Answer>;
using Cases = std::vector<Case>;
using Column = Eigen::ArrayXd;  // a number of each question
using Columns = std::map<std::string, Column>;
using Patterns = std::vector<Pattern>;

// A rule that holds for fewer numbers or cases may be chance.
inline constexpr std::size_t kEnough = 3;

// A wrong part: its questions, the right answers and its own.
struct WrongPart {
  int part;
  const Cases& cases;
  const Answers &right, &got;
  Columns columns;  // of its own answers
};

// columns.cpp: what stands for a name in a formula, with these answers.
Columns columns_of(int part, const Cases& cases, const Answers& right, const Answers& got);

// expression.cpp: the values of a formula that is written as text, "y - (l/2) abs(cos(theta))":
// with
// + - / ^, products without a sign ("2 mu dt"), < and =, which give 1 or 0, cos, sin, sqrt, abs,
// floor, round, min, max, mod, atan2, and corner_x(angle, l) and corner_y(angle, l). Throws
// std::exception if a name is unknown.
Column value(const std::string& formula, const Columns& columns);

// Of one question alone, and of no answer.
double value_in(const Case& c, const std::string& formula);

// 1 where two columns agree, as `same` says, and 0 elsewhere.
Column are_same(const Column& a, const Column& b);

// From the centre to the lowest corner of a square that is turned by this angle.
Eigen::Vector2d lowest_corner(double angle, double side);

// A quantity: its name, and its entries in an answer.
struct Quantity {
  std::string name;
  std::vector<Eigen::Index> entries;
};
std::vector<Quantity> quantities(int part);

// A wrong number of an answer; those of answers that threw are left out.
struct Number {
  std::size_t question;
  Eigen::Index entry;
  double right, got;
};

// An input of the questions; g stands for its three entries.
struct Input {
  const char* name;
  double value;
};
inline constexpr std::size_t kParameters = 7;  // among the inputs; they come first
std::vector<Input> inputs_of(const Case& c);

std::string digits(double x);          // six
bool is_finite(const Answer& answer);  // whether it didn't throw, and all its numbers are finite

// --- findings ---

// "Your phi is y - l/2 in every case", and the like: what the rows of this name and the part's
// number in tables.txt say of formulas that give all of a quantity's numbers where the right one
// doesn't. If two formulas do, both are named; if more do, none is.
Patterns formulas(const WrongPart& wrong, const std::string& rows = "");

// One rule for every wrong number (a factor, a difference, a constant, few digits); else up to two,
// each for a quantity with its own rule; else none.
Patterns rules(const WrongPart& wrong, const std::vector<Number>& numbers);

// "Changing only l doesn't change phi in your answers, but it should": if it is so in all questions
// that differ in this number alone.
Patterns inputs(const WrongPart& wrong);

// Whether the same question, asked twice, gets two answers.
bool answers_differ_when_asked_again(const WrongPart& wrong);

// "Only those where ... are wrong", of the questions with these numbers. None if too few others are
// right, or if nothing sets the wrong ones apart.
Patterns where(const WrongPart& wrong, const std::vector<Number>& numbers);

}  // namespace bounce::tests
