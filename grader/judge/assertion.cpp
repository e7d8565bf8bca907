#include "assertion.hpp"

#include <algorithm>
#include <cctype>

namespace bounce::judge {
namespace {

using View = std::string_view;

bool digit(char c) { return c >= '0' && c <= '9'; }

bool of_a_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || View("_.+-").find(c) != View::npos;
}

// "File.h:12" from "program: /path/File.h:12: function: "; empty if there is none.
View place_in(View line) {
  for (std::size_t colon = line.find(':'); colon != View::npos; colon = line.find(':', colon + 1)) {
    std::size_t end = colon + 1;
    while (end < line.size() && digit(line[end])) ++end;
    if (end == colon + 1 || line.substr(end, 2) != ": ") continue;
    std::size_t start = colon;
    while (start > 0 && of_a_name(line[start - 1])) --start;
    if (start < colon) return line.substr(start, end - start);
  }
  return {};
}

// What an operation of Eigen says of shapes that don't fit, and which operation it is.
struct Operation {
  View assertion, words;
};

constexpr Operation kOperations[] = {
    {"lhs.cols() == rhs.rows()",
     "a product whose left matrix has another number of columns than the right one has rows"},
    {"aLhs.rows() == aRhs.rows()",
     "a sum, a difference or another operation by entries on two different shapes"},
    {"dst.rows() == ", "an assignment to a matrix or vector of another shape"},
    {"== other.size()", "a dot product of vectors of different lengths"},
    {"Too many rows passed to comma", "<< with more rows than the matrix has"},
    {"Too many coefficients passed to comma", "<< with more numbers than the matrix has"},
    {"Too few coefficients passed to comma", "<< with fewer numbers than the matrix has"},
    {"Cannot comma-initialize", "<< into a matrix without entries"},
    {"__n < this->size()", "an index beyond the end of a std::vector or std::array"},
    {"startRow >= 0", "a block that isn't inside its matrix"},
    {"BlockRows==1", "a row or a column that the matrix doesn't have"},
    {"AtCompileTime", "a size that is negative, or that a matrix of fixed size doesn't have"},
    {"row >= 0 && row < rows()", "an index is out of range"},
    {"index >= 0 && index < size()", "an index is out of range"}};

// The operation's words; for another assertion, its place and its own words, cut.
std::string in_words(View place, View what) {
  for (const Operation& operation : kOperations) {
    if (what.find(operation.assertion) != View::npos) return std::string(operation.words);
  }
  return std::string(place.substr(0, 120)) + ": " + std::string(what.substr(0, 120));
}

// Parses a line of assert() or __glibcxx_assert: place: function: Assertion `what' failed.
std::string in_line(View line) {
  const View word = "Assertion ";
  const std::size_t at = line.find(word), quote = at + word.size();
  const std::size_t end = line.rfind("' failed");
  if (at == View::npos || end == View::npos || end <= quote) return "";
  if (line[quote] != '`' && line[quote] != '\'') return "";
  const View place = place_in(line.substr(0, at));
  if (place.empty()) return "";
  return in_words(place, line.substr(quote + 1, std::min<std::size_t>(end - quote - 1, 400)));
}

}  // namespace

std::string assertion_in(View print) {
  while (!print.empty()) {
    const std::size_t end = std::min(print.find('\n'), print.size());
    if (std::string found = in_line(print.substr(0, end)); !found.empty()) return found;
    print.remove_prefix(std::min(end + 1, print.size()));
  }
  return "";
}

}  // namespace bounce::judge
