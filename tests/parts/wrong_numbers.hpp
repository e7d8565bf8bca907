// The wrong numbers among a part's answers, and the names of what they belong to.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

using Words = std::vector<std::string>;

// Numbers or cases, below which a rule may be chance.
inline constexpr std::size_t kEnough = 3;

// A name and the entries of an answer that it stands for.
struct Quantity {
  std::string name;
  std::vector<Eigen::Index> entries;
  Words names;  // of the entries, where a name alone says too little
};

// All that a part answers; for parts 1 to 3.
std::vector<Quantity> quantities(int part);

bool is_touched(const Quantity& quantity, const std::set<Eigen::Index>& entries);

std::vector<Eigen::Index> range(Eigen::Index from, Eigen::Index count, Eigen::Index step = 1);

struct Number {
  std::size_t question;
  Eigen::Index entry;
  double right, got;
};

// Wrong answers beside right ones. What threw isn't among them.
struct Wrong {
  std::vector<Number> numbers;
  std::set<std::size_t> questions;
  std::set<Eigen::Index> entries;
};

Wrong wrong_numbers(const std::vector<Answer>& right, const std::vector<Answer>& got);

// "a, b and c".
std::string joined(const Words& words, const std::string& last = " and ");

}  // namespace bounce::tests
