#include "failed_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bounce::words {
namespace {

using Lines = std::vector<std::string>;

constexpr double kNothing = 1e-14;       // numbers below this are rounding errors of 0
constexpr double kNeverSet = 1e300;      // g++ fills an unset number with -5e303, clang with NaN
constexpr std::size_t kLineLength = 72;  // of two matrices side by side
const std::string kAgain =
    " when run again in a different order, though correct the first time (is something kept from "
    "one call to the next?); ";

std::size_t size(const Rows& rows) { return rows.empty() ? 0 : rows.size() * rows[0].size(); }

// Makes lines equally long.
void pad(Lines& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, line.size());
  for (std::string& line : lines) line.resize(width, ' ');
}

// Six digits, or more if a wrong number would look the same as the right one, or stands alone.
int digits_for(const Quantity& q, bool shown) {
  for (std::size_t i = 0; i < q.got.size(); ++i) {
    for (std::size_t j = 0; j < q.got[i].size(); ++j) {
      const bool differs = shown && number(q.got[i][j], 6) != number(q.expected[i][j], 6);
      if (!q.right[i][j] && !differs) return 12;
    }
  }
  return 6;
}

// A title, and a line for each row of the matrix, its columns aligned; a wrong entry is marked.
Lines lines_of(const char* title, const Rows& m, const std::vector<std::vector<bool>>* right,
               int digits) {
  Lines rows(m.size(), size(m) == 1 ? "" : "[");
  for (std::size_t j = 0; !m.empty() && j < m[0].size(); ++j) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::string entry = number(m[i][j], digits);
      const bool is_right = !right || (*right)[i][j];
      rows[i] += (j > 0 ? "  " : "") + (is_right ? " " + entry + " " : ">" + entry + "<");
    }
    pad(rows);
  }
  for (std::string& row : rows) row += size(m) > 1 ? "]" : "";
  rows.insert(rows.begin(), title);
  pad(rows);
  return rows;
}

// Both matrices, side by side if that fits into a line, else one below the other.
std::string side_by_side(const Quantity& q, bool shown) {
  const int digits = digits_for(q, shown);
  Lines lines = lines_of("yours, >wrong<", q.got, &q.right, digits);
  const Lines rights = shown ? lines_of("right", q.expected, nullptr, digits) : Lines{};
  if (shown && lines[0].size() + 4 + rights[0].size() < kLineLength) {
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] += "    " + rights[i];
  } else {
    lines.insert(lines.end(), rights.begin(), rights.end());
  }
  std::string text = "  " + q.name + ", in " + q.unit + "\n";
  for (const std::string& line : lines) {
    text += "    " + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

// Describes a number that can't be an answer to any question, such as one that was never set, which
// a build fills with an odd value. Empty if there is none.
std::string odd_number(const Quantity& q) {
  const std::string subject = size(q.got) == 1 ? "  it is " : "  an entry is ";
  for (const auto& row : q.got) {
    for (const double x : row) {
      if (std::isinf(x))
        return subject + number(x, 6) +
               ": division by zero? In C++, 1 / 6 is 0: both are integers.\n";
      if (std::abs(x) <= kNeverSet) continue;
      return subject + number(x, 2) + ": was it ever set? If so, look for " +
             (std::isnan(x) ? "0/0 or sqrt(-1).\n" : "what makes it so large.\n");
    }
  }
  return "";
}

std::string explanation(const Quantity& q, bool always_zero) {
  if (!always_zero) return odd_number(q);
  return size(q.got) == 1 ? "  it is 0. Was it filled in? Was a minimum ever found?\n"
                          : "  every entry is 0: is it filled in?\n";
}

// "(a, b, c)", or the rows of a matrix below each other; a scalar without brackets.
std::string in_brackets(const Rows& m, const std::string& indent) {
  if (size(m) == 1) return number(m[0][0], 12);
  std::string text = "(";
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (i > 0) text += m[0].size() == 1 ? ", " : ")\n" + indent + "(";
    for (std::size_t j = 0; j < m[i].size(); ++j) text += (j > 0 ? ", " : "") + number(m[i][j], 12);
  }
  return text + ")";
}

std::string in_words(const std::vector<Value>& parameters) {
  std::string text;
  for (const Value& p : parameters) {
    text += (text.empty() ? "" : ", ") + p.name + " = " + in_brackets(p.rows, "");
    text += (p.unit.empty() ? "" : " ") + p.unit;
  }
  return text.empty() ? "the assignment's" : text;
}

}  // namespace

std::string number(double x, int digits) {
  if (std::isnan(x)) return "nan";  // without its sign
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, std::abs(x) < kNothing ? 0.0 : x);
  return text;
}

std::string question(const FailedCase& failed) {
  const std::string label = "\n  input    ", blanks(label.size() - 1, ' ');
  std::string text = failed.name + (failed.hidden ? " (a hidden case)" : "") + label;
  for (const Value& x : failed.input) {
    const std::string begin = x.name + " = ";
    text += begin + in_brackets(x.rows, blanks + std::string(begin.size(), ' ')) + "  " + x.unit;
    if (x.name[0] == 'q' && !in_degrees(x.rows.back()[0]).empty())
      text += ", theta = " + in_degrees(x.rows.back()[0]);
    text += "\n" + blanks;
  }
  return text + "parameters: " + in_words(failed.parameters);
}

std::string got(const std::string& sentence) { return "  got      " + sentence + "\n"; }

std::string counts(const FailedCase& failed) {
  const std::string cases = std::to_string(failed.cases);
  if (failed.ended_at > 0)
    return "ended at case " + std::to_string(failed.ended_at) + " of " + cases;
  return std::to_string(failed.wrong) + " of " + cases + " cases wrong";
}

std::string numbers(const FailedCase& failed, bool shown) {
  std::string text;
  if (shown && !failed.contact.empty()) text += "  " + failed.contact + "\n";
  if (!failed.sentence.empty()) text += got(failed.sentence);
  for (const Quantity& q : failed.quantities)
    text += side_by_side(q, shown) + explanation(q, failed.always_zero);
  if (!shown && !failed.quantities.empty())
    text += "  the right numbers aren't shown, as the case is hidden\n";
  if (!text.empty()) text.pop_back();
  return text;
}

std::string lines(const FailedCase& failed, bool shown) {
  const bool is_simplest = !failed.quantities.empty();
  const std::string which = failed.ended_at > 0 ? "the last: "
                            : is_simplest       ? "the simplest: "
                                                : "the first: ";
  return counts(failed) + (failed.again ? kAgain : "; ") + which + question(failed) + "\n" +
         numbers(failed, shown || !failed.hidden) +
         (failed.smallest ? on_paper(*failed.smallest, failed) : "");
}

}  // namespace bounce::words
