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

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

std::size_t width_of(const Words& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, line.size());
  return width;
}

// Six digits, or more if a wrong number would look the same as the right one.
int digits_for(const Difference& d, const Marks& right) {
  for (Index i = 0; i < d.got.size(); ++i) {
    if (!right(i) && number(d.got(i), 6) == number(d.expected(i), 6)) return 12;
  }
  return 6;
}

// A title, and a line for each row of the matrix, its columns aligned; a wrong entry is marked.
Words lines_of(const std::string& title, const Eigen::MatrixXd& m, const Marks& right, int digits) {
  Words rows(static_cast<std::size_t>(m.rows()), m.size() == 1 ? "" : "[");
  for (Index j = 0; j < m.cols(); ++j) {
    Words entries;
    for (Index i = 0; i < m.rows(); ++i) {
      const std::string entry = number(m(i, j), digits);
      entries.push_back(right(i, j) ? " " + entry + " " : ">" + entry + "<");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] += (j > 0 ? "  " : "") + padded(entries[i], width_of(entries));
    }
  }
  for (std::string& row : rows) {
    if (m.size() > 1) row += "]";
    if (row.back() == ' ') row.pop_back();
  }
  rows.insert(rows.begin(), title);
  return rows;
}

// Both matrices, side by side if that fits into a line, else one below the other.
std::string side_by_side(const Case& c, const Difference& d) {
  const Marks right = agrees(c, d.expected, d.got);
  const Marks all = Marks::Constant(right.rows(), right.cols(), true);
  const int digits = digits_for(d, right);
  const Words yours = lines_of("yours, >wrong<", d.got, right, digits);
  const Words rights = lines_of("right", d.expected, all, digits);
  const std::size_t width = width_of(yours) + 4;
  const bool beside = width + rights.back().size() < 72;
  std::string text = "  " + d.name + ", in " + d.unit + "\n";
  for (std::size_t i = 0; i < yours.size(); ++i) {
    text += "    " + (beside ? padded(yours[i], width) + rights[i] : yours[i]) + "\n";
  }
  for (std::size_t i = 0; i < (beside ? 0 : rights.size()); ++i) text += "    " + rights[i] + "\n";
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

bool are_zero(const double* numbers, Index size) {
  return std::all_of(numbers, numbers + size, [](double x) { return x == 0; });
}

// What may have gone wrong, if one reason explains every wrong entry; else empty.
std::string explanation(const Case& c, const Difference& d) {
  if (const std::string odd = odd_number(d.got); !odd.empty()) return odd;
  if (are_zero(d.got.data(), d.got.size())) {
    return d.got.size() > 1 ? "  every entry is 0: is it filled in?\n"
                            : "  it is 0: not filled in, or a smallest that was never found?\n";
  }
  const Marks right = agrees(c, d.expected, d.got);
  Words fit;
  double times = 1;
  for (const auto& [words, formula] : alternatives("factors")) {
    const double factor = value_in(c, formula);
    const Marks scaled = agrees(c, factor * d.expected, d.got);
    if (!(right || (scaled && d.expected.array() != 0)).all()) continue;
    fit.push_back(words);
    times = factor;
  }
  if (fit.empty()) return "";
  const std::string words = joined(fit, " or "), value = number(times, 6);
  return "  wrong entries are " + words + (words == value ? "" : " = " + value) +
         " times the right ones\n";
}

// The force that follows from a velocity after the step: M (v' - v) / dt - f_e.
std::string forces(const Case& c, const Vector3& v) {
  const Vector3 acceleration = (v - c.v) / c.params.dt - c.params.g;
  const Vector3 f = c.params.M() * acceleration;
  const double zero = 1e-9 * f.norm();  // rounding errors are shown as 0
  const auto said = [&](double x) { return number(std::abs(x) < zero ? 0 : x, 6); };
  return "(" + said(f.x()) + ", " + said(f.y()) + ") N";
}

// How the corner moves before the step, from the question's J.
std::string corner_before(const Case& c) {
  const double v_t = c.J.col(0).dot(c.v), v_n = c.J.col(1).dot(c.v);
  return "  before the step the corner slides to the " + std::string(v_t > 0 ? "right" : "left") +
         " at " + number(std::abs(v_t), 6) + " m/s and " + (v_n < 0 ? "comes down" : "goes up") +
         " at " + number(std::abs(v_n), 6) + " m/s\n";
}

std::string about_step(const Case& c, const Difference& d) {
  const bool touches = c.corner.rfind("corner", 0) == 0;
  if (d.name != kNewVelocity || !touches || !d.got.allFinite()) return "";
  return "  the contact force (f_t2 - f_t1, f_n) that v' tells of:\n    yours " + forces(c, d.got) +
         ", right " + forces(c, d.expected) + "\n";
}

}  // namespace

std::string feedback(const Case& c, const Problem& problem) {
  std::string text;
  if (!c.corner.empty()) text += "  " + c.corner + "\n";
  if (!are_zero(c.J.data(), c.J.size())) text += corner_before(c);
  if (!problem.sentence.empty()) text += "  " + problem.sentence + "\n";
  for (const Difference& d : problem.differences) {
    text += side_by_side(c, d) + explanation(c, d) + about_step(c, d);
  }
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace bounce::tests
