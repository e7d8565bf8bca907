// The formulas that a part's wrong answers may follow, one a row; formulas.cpp fits them.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace bounce::tests {

// A list of alternatives is written "WORDS := FORMULA", with "; " between them, or as one text
// where the words are the formula. The symbols are those of formulas.cpp, symbols_of.
struct Row {
  std::string where = "1";  // only questions in which this isn't 0;
  std::string right = "";   // only if these are right in all of them,
  std::string wrong = "";   // and one of these isn't; of the numbers, if it is empty
  // "a2 = -r_y; a5 = r_x": numbers of the answers and their formulas. {0} and {1} stand for an
  // alternative of the lists, and # for 0, 1 and 2 (in kBlock 0 to 8).
  std::string numbers = "";
  std::string words = "{0}";  // of the formula
  std::vector<std::string> lists = {};
  // Alternatives for {each}, which are fitted to each number by itself; a ? in one is any number.
  std::string each = "";
  std::string bounds = "";    // the numbers' names, if each may be right between two bounds
  bool otherwise = false;     // only if no row above says something
  std::string sentence = "";  // {} stands for the words of what fits
};

extern const std::map<int, std::vector<Row>> kRows;  // of each part

// For the 3x3 block of V: {each} is the sign of an entry.
extern const std::vector<Row> kBlock;

}  // namespace bounce::tests
