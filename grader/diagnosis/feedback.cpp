#include "feedback.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "findings.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;
using Marks = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double kNothing = 1e-14;   // numbers below this are rounding errors of 0
constexpr double kNeverSet = 1e300;  // g++ fills an unset number with -5e303, clang with NaN

std::string number(double x, int digits) {
  if (std::isnan(x)) return "nan";  // without its sign
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, std::abs(x) < kNothing ? 0.0 : x);
  return text;
}

// Makes lines equally long.
void pad(Words& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, line.size());
  for (std::string& line : lines) line.resize(width, ' ');
}

// Six digits, or more if a wrong number would look the same as the right one.
int digits_for(const Difference& d, const Marks& right) {
  for (Index i = 0; i < d.got.size(); ++i) {
    if (!right(i) && number(d.got(i), 6) == number(d.expected(i), 6)) return 12;
  }
  return 6;
}

// A title, and a line for each row of the matrix, its columns aligned; a wrong entry is marked.
Words lines_of(const char* title, const Eigen::MatrixXd& m, const Marks& right, int digits) {
  Words rows(static_cast<std::size_t>(m.rows()), m.size() == 1 ? "" : "[");
  for (Index j = 0; j < m.cols(); ++j) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::string entry = number(m(Index(i), j), digits);
      rows[i] += (j > 0 ? "  " : "") + (right(Index(i), j) ? " " + entry + " " : ">" + entry + "<");
    }
    pad(rows);
  }
  for (std::string& row : rows) row += m.size() > 1 ? "]" : "";
  rows.insert(rows.begin(), title);
  pad(rows);
  return rows;
}

// Both matrices, side by side if that fits into a line, else one below the other.
std::string side_by_side(const Case& c, const Difference& d) {
  const Marks right = agrees(c, d.expected, d.got);
  const Marks all = Marks::Constant(right.rows(), right.cols(), true);
  const int digits = digits_for(d, right);
  Words lines = lines_of("yours, >wrong<", d.got, right, digits);
  const Words rights = lines_of("right", d.expected, all, digits);
  if (lines[0].size() + 4 + rights[0].size() < 72) {
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] += "    " + rights[i];
  } else {
    lines.insert(lines.end(), rights.begin(), rights.end());
  }
  std::string text = "  " + d.name + ", in " + d.unit + "\n";
  for (const std::string& line : lines) {
    text += "    " + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

// Describes a number that can't be an answer to any question, such as one that was never set, which
// a student's build fills with an odd value. Empty if there is none.
std::string odd_number(const Eigen::MatrixXd& got) {
  const std::string subject = got.size() > 1 ? "  an entry is " : "  it is ";
  for (Index i = 0; i < got.size(); ++i) {
    const double x = got(i);
    if (std::isinf(x))
      return subject + number(x, 6) + ": a division by zero? 1 / 6 is 0, of whole numbers.\n";
    if (std::abs(x) <= kNeverSet) continue;
    return subject + number(x, 2) + ": was it ever set? If so, look for " +
           (std::isnan(x) ? "0/0 or sqrt(-1).\n" : "what makes it grow.\n");
  }
  return "";
}

// What no answer can be, or what isn't filled in; else empty.
std::string explanation(const Difference& d) {
  if (!d.got.isZero(0)) return odd_number(d.got);
  return d.got.size() > 1 ? "  every entry is 0: is it filled in?\n"
                          : "  it is 0: not filled in, or a smallest that was never found?\n";
}

}  // namespace

std::string feedback(const Case& c, const Problem& problem) {
  std::string text;
  if (!c.corner.empty()) text += "  " + c.corner + "\n";
  if (!problem.sentence.empty()) text += "  " + problem.sentence + "\n";
  for (const Difference& d : problem.differences) {
    text += side_by_side(c, d) + explanation(d);
  }
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace bounce::tests
