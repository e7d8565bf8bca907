#include "failed_case.hpp"

#include <algorithm>
#include <cmath>

namespace bounce::words {
namespace {

constexpr int kDigits = 6, kMore = 12;
constexpr double kTolerance = 1e-9;

bool is_round(double x, int digits) {
  return std::abs(std::stod(number(x, digits)) - x) <= 1e-13 * std::abs(x);
}

std::string angle(double radians) {
  if (radians == 0) return "0";
  const std::string degrees = in_degrees(radians);
  return degrees.empty() ? number(radians, kMore) + " rad" : degrees;
}

// "m, m, rad" of an entry; a unit for all entries may stand alone.
std::string unit_of(const std::string& units, std::size_t entry) {
  std::size_t from = 0;
  for (std::size_t comma; entry > 0 && (comma = units.find(", ", from)) != std::string::npos;
       --entry)
    from = comma + 2;
  const std::string unit = units.substr(from, units.find(", ", from) - from);
  return unit.empty() || unit == "1" || unit == "no unit" ? "" : " " + unit;
}

std::string entry(double x, const std::string& unit, int digits) {
  if (unit == " rad" && digits == kMore) return angle(x);
  return number(x, digits) + (x == 0 ? "" : unit);
}

// "0.1 m", "(0, 0.1 m, 30°)" with a unit behind each entry that isn't 0, or "(1, 0; 0, 1)".
std::string in_line(const Value& value, const Rows& rows, int digits) {
  if (rows.size() == 1 && rows[0].size() == 1)
    return number(rows[0][0], digits) + unit_of(value.unit, 0);
  const bool is_vector = rows.empty() || rows[0].size() == 1;
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      text += (i + j == 0 ? "(" : j == 0 && !is_vector ? "; " : ", ");
      text += entry(rows[i][j], is_vector ? unit_of(value.unit, i) : "", digits);
    }
  }
  return text + ")";
}

std::string input_of(const Question& question) {
  std::string text;
  for (const auto* values : {&question.input, &question.parameters}) {
    for (Value x : *values) {
      if (x.name == "T") x.unit.clear();
      text += (text.empty() ? "" : ", ") + x.name + " = " + in_line(x, x.rows, kMore);
    }
  }
  return text;
}

// Of a matrix the first entry that is wrong, "entry (0, 1) of J".
struct Wrong {
  Value right;
  Rows got;
};

Wrong to_show(const Smallest& smallest) {
  const auto& [name, right, unit] = smallest.expected;
  if (right.empty() || right[0].size() == 1) return {smallest.expected, smallest.got};
  for (std::size_t i = 0; i < right.size(); ++i) {
    for (std::size_t j = 0; j < right[i].size(); ++j) {
      const double x = right[i][j], got = smallest.got[i][j];
      if (std::abs(got - x) <= kTolerance * std::max(1.0, std::abs(x))) continue;
      const std::string entry = "(" + std::to_string(i) + ", " + std::to_string(j) + ")";
      return {{"entry " + entry + " of " + name.substr(0, name.find(" = ")), {{x}}, ""}, {{got}}};
    }
  }
  return {smallest.expected, smallest.got};
}

std::string in_a_sentence(const Smallest& smallest) {
  const Wrong wrong = to_show(smallest);
  const Value& right = wrong.right;
  const auto said = [&](const Rows& rows, int digits) { return in_line(right, rows, digits); };
  const int digits = said(right.rows, kDigits) == said(wrong.got, kDigits) ? kMore - 1 : kDigits;
  std::string text = input_of(smallest.asked) + ", all else as in the assignment: " + right.name +
                     " = " + said(right.rows, digits) + " is right, yours is " +
                     said(wrong.got, digits);
  if (smallest.before) {
    text = "a call with " + input_of(*smallest.before) + ", then one with " + text +
           "; without the first call yours is right";
  }
  return text + ".";
}

bool are_same(const std::vector<Value>& some, const std::vector<Value>& others) {
  return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                    [](const Value& a, const Value& b) { return a.rows == b.rows; });
}

}  // namespace

std::string in_degrees(double radians) {
  constexpr int kFew = 4;
  const double degrees = radians / kDegree;
  const bool is_rounder = radians != 0 && is_round(degrees, kFew) && !is_round(radians, kFew);
  return is_rounder ? number(degrees, kFew) + "\u00B0" : "";
}

std::string on_paper(const Smallest& smallest, const FailedCase& failed) {
  const bool is_shown = !smallest.before && are_same(smallest.asked.input, failed.input) &&
                        are_same(smallest.asked.parameters, failed.parameters);
  std::string text = is_shown ? "" : "\n  smallest " + in_a_sentence(smallest);
  for (const auto& [value, equation] : smallest.on_the_way) {
    text += (text.empty() ? "\n  on paper " : "\n           ") + value.name + " = " +
            in_line(value, value.rows, kDigits) + "  (eq. " + std::to_string(equation) + ")";
  }
  return text;
}

}  // namespace bounce::words
