#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "cases.hpp"

namespace bounce::examples {
namespace {

constexpr std::size_t kLargest = 1 << 16;            // bytes of a file
constexpr double kRounding = 1e-6;                   // in units of the last digit
constexpr double kNudge = 1e-7, kContinuous = 1e-4;  // m or rad; and what may become of it

const Program& right_program(int part, const Table& table) {
  const auto is_it = [&](const Program& one) { return one.part == part && one.name == "-"; };
  return *std::find_if(table.programs.begin(), table.programs.end(), is_it);
}

// Whether the number, rounded or cut off to the digits that were written, is what was written.
bool agrees(double value, const Given& claim) {
  const double off = (value - claim.value) / claim.unit, further = value < 0 ? -off : off;
  return std::abs(off) < 0.5 + kRounding || (0 < further && further < 1 - kRounding);
}

bool agrees(const Values& values, const Case& asked) {
  return std::all_of(asked.outputs.begin(), asked.outputs.end(), [&](const Given& claim) {
    return agrees(values[claim.quantity->place], claim);
  });
}

// The input by which rounding decides what a program answers: where this changes by next to
// nothing, an answer changes by more. Null if there is none.
const Quantity* undecided(const Program& program, const Case& asked, const Table& table) {
  const Values here = table.run(program, asked.values);
  const auto changes_with = [&](const Quantity& input, double nudge) {
    Values beside = asked.values;
    beside[input.place] += nudge;
    const Values there = table.run(program, beside);
    return std::any_of(asked.outputs.begin(), asked.outputs.end(), [&](const Given& claim) {
      const double a = here[claim.quantity->place], b = there[claim.quantity->place];
      return !(std::abs(a - b) < kContinuous * std::max({1.0, std::abs(a), std::abs(b)}));
    });
  };
  for (const Quantity& input : table.inputs) {
    if (input.name != "y" && input.name != "theta") continue;
    if (changes_with(input, -kNudge) || changes_with(input, kNudge)) return &input;
  }
  return nullptr;
}

void require_decided(const Case& asked, const Table& table) {
  const Quantity* input = undecided(right_program(asked.part, table), asked, table);
  if (!input) return;
  std::size_t column = 1;
  for (const Given& given : asked.inputs) {
    if (given.quantity == input) column = given.column;
  }
  throw Problem(column,
                input->name == "theta"
                    ? "the square lies flat, or nearly so: two corners are equally low, and "
                      "either is right; turn it by theta"
                    : "phi is so near to delta that rounding decides whether the corner "
                      "touches: change y");
}

// How far off a number is, in words that don't tell the right one.
std::string distance(double right, const Given& claim) {
  const double size = std::abs(claim.value / right);
  if (std::abs(right) < 1e-12) return "isn't right";
  if (claim.value == 0) return "isn't 0";
  if (claim.value * right < 0) {
    Given turned = claim;
    turned.value = -claim.value;
    return agrees(right, turned) ? "has the other sign" : "has another sign and another size";
  }
  const double share = std::abs(size - 1);
  const char* much = share < 0.02  ? "less than 2 %"
                     : share < 0.2 ? "2 to 20 %"
                     : share < 1   ? "20 to 100 %"
                                   : "more than 100 %";
  return std::string("is too ") + (size > 1 ? "large" : "small") + " in size, by " + much;
}

Verdict judged(const Case& asked, const std::string& place, const Table& table) {
  require_decided(asked, table);
  Verdict verdict{place, asked.part, false, {}, ""};
  const Values right = table.run(right_program(asked.part, table), asked.values);
  for (const Given& claim : asked.outputs) {
    if (agrees(right[claim.quantity->place], claim)) continue;
    verdict.sentence += (verdict.sentence.empty() ? "" : "; ") + claim.quantity->name + " " +
                        distance(right[claim.quantity->place], claim);
  }
  verdict.is_right = verdict.sentence.empty();
  for (const Program& program : table.programs) {
    if (program.part != asked.part || program.name == "-") continue;
    const bool answers_so = agrees(table.run(program, asked.values), asked);
    if (answers_so == verdict.is_right || undecided(program, asked, table)) continue;
    if (verdict.is_right) {
      verdict.caught.push_back(program.name);
    } else {
      verdict.sentence += "; wrong program " + program.name + " answers this";
    }
  }
  return verdict;
}

}  // namespace

Judged judge(const std::string& cases, const Table& table) {
  Judged all;
  std::istringstream lines(cases.substr(0, kLargest));
  std::size_t number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    const std::string place = "line " + std::to_string(number);
    try {
      const Case asked = read_case(line, table);
      if (asked.part) all.verdicts.push_back(judged(asked, place, table));
    } catch (const Problem& problem) {
      const std::string column = ", column " + std::to_string(problem.column);
      all.verdicts.push_back({place + column, 0, false, {}, problem.what()});
    }
  }
  if (cases.size() > kLargest) {
    all.verdicts.push_back({"line " + std::to_string(number), 0, false, {}, "only 64 KB are read"});
  }
  std::set<std::string> caught;
  for (const Verdict& verdict : all.verdicts) {
    caught.insert(verdict.caught.begin(), verdict.caught.end());
  }
  for (const Program& program : table.programs) {
    if (program.name == "-") continue;
    (caught.count(program.name) ? all.caught : all.missed).push_back(program.name);
  }
  return all;
}

}  // namespace bounce::examples
