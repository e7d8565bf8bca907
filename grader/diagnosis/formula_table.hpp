// The formulas that a part's wrong answers may follow, one a row; formulas.cpp fits them.
#pragma once

#include <string>
#include <vector>

namespace bounce::tests {

// A list of alternatives is written "WORDS := FORMULA", with "; " between them, or as one text
// where the words are the formula. The symbols are those of formulas.cpp, symbols_of.
struct Row {
  int part;
  std::string sentence;      // {} stands for the words of what fits
  std::string targets;       // numbers of the answers; for # stand 0, 1, 2 (in kBlock 0 to 8)
  std::string formula = "";  // of each target; {0} and {1} stand for an alternative of the lists
  std::vector<std::string> lists = {};
  std::string words = "{0}";
  std::string each = "";    // alternatives for {each}, which are fitted to each target by itself;
                            // a ? in one is any number
  std::string where = "1";  // only questions in which this isn't 0
  std::string right = "";   // only if these are right in all of them,
  std::string wrong = "";   // and one of these isn't; of the targets, if it is empty
  std::string bounds = "";  // the targets' names, if each may be right between two bounds
  bool otherwise = false;   // only if no row above says something
};

extern const std::vector<Row> kRows;

// For the 3x3 block of V: {each} is the sign of an entry.
extern const std::vector<Row> kBlock;

}  // namespace bounce::tests
