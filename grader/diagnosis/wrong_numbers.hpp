// Collects the wrong numbers among a part's answers, and names their quantities.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

using Words = std::vector<std::string>;

// A rule that holds for fewer numbers or cases may be chance.
inline constexpr std::size_t kEnough = 3;

// A formula or a factor, and its value in one question.
struct Value {
  const char* words;
  double value;
};

// A quantity: its name, and its entries in an answer.
struct Quantity {
  std::string name;
  std::vector<Eigen::Index> entries;
  Words names;  // of the entries, if the quantity's name isn't enough
};

// The quantities of a part's answer; for parts 1 to 3.
std::vector<Quantity> quantities(int part);

bool is_touched(const Quantity& quantity, const std::set<Eigen::Index>& entries);

std::vector<Eigen::Index> range(Eigen::Index from, Eigen::Index count, Eigen::Index step = 1);

struct Number {
  std::size_t question;
  Eigen::Index entry;
  double right, got;
};

// Wrong answers and the right ones. Answers that threw aren't included.
struct Wrong {
  std::vector<Number> numbers;
  std::set<std::size_t> questions;
  std::set<Eigen::Index> entries;
};

Wrong wrong_numbers(const std::vector<Answer>& right, const std::vector<Answer>& got);

// To six significant digits.
std::string digits(double x);

// Whether neither threw, and the answer's numbers are as many as the right ones, and finite.
bool is_finite(const Answer& right, const Answer& got);

// Factors by which a number may be wrong, with their names in the assignment.
std::vector<Value> factors(const Parameters& params);

// "a, b and c".
std::string joined(const Words& words, const std::string& last = " and ");

}  // namespace bounce::tests
