// What tables.txt holds: it says there what its lines are.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hints.hpp"

namespace bounce::tests {

using words::Pattern;
using Words = std::vector<std::string>;

// The rows of a part, each with what its lines say, by their names.
using Row = std::map<std::string, std::string>;
const std::vector<Row>& rows_of(const std::string& part);
std::string text_of(const Row& row, const std::string& name);  // empty if it has no such line
Words split(const std::string& list, char between = ';');

// The alternatives of a list, or of the list that has this name.
struct Alternative {
  std::string id, words, formula;
};
std::vector<Alternative> alternatives(const std::string& list);

std::string joined(const Words& words, const std::string& last = " and ");  // "a, b and c"
std::string replaced(std::string text, const std::string& from, const std::string& to);

// Throws std::out_of_range for an id that no row has.
std::string sentence_of(const Pattern& pattern);

}  // namespace bounce::tests
