#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>

namespace bounce::examples {
namespace {

// ---- reading ----

constexpr int kDigits = 3;
constexpr double kDegree = 0.017453292519943295;
constexpr double kExactly = 1e-9;  // how near to a plain 0 counts as 0
constexpr const char* kOfNames = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_'";
constexpr const char* kOfNumbers = "0123456789.eE+-";

// One sentence about a place in the file; lines and columns count from 1.
struct Problem : std::runtime_error {
  Problem(std::size_t column_, const std::string& sentence)
      : std::runtime_error(sentence), column(column_) {}
  std::size_t column;
};

// A number that the student gives to a quantity.
struct Given {
  const Quantity* quantity;
  std::size_t column;
  double value;
  double unit;  // of its last digit
};

struct Case {
  int part = 0;
  std::vector<Given> inputs, outputs;
  Values values;  // of all inputs
};

bool is_digit(char c) { return '0' <= c && c <= '9'; }

// Reads a line from its begin to its end.
class Reader {
 public:
  explicit Reader(const std::string& line) : line_(line.substr(0, line.find('#'))) {
    skip(" \t\r");
  }

  std::size_t column() const { return at_ + 1; }
  bool is_at_end() const { return at_ == line_.size(); }

  // The characters from here that are of these; blanks behind them are skipped.
  std::string take_all(const char* characters) {
    const std::size_t begin = at_;
    skip(characters);
    std::string taken = line_.substr(begin, at_ - begin);
    if (at_ + 1 < line_.size() && line_[at_] == ',' && is_digit(line_[at_ + 1])) {
      throw Problem(
          column(),
          "write decimals with a point, not a comma, as in 0.5; put a space after a comma "
          "that separates two numbers");
    }
    skip(" \t\r");
    return taken;
  }
  char take_one() {
    const char one = line_[at_];
    take(std::string(1, one));
    return one;
  }
  bool take(const std::string& text) {
    if (line_.compare(at_, text.size(), text) != 0) return false;
    at_ += text.size();
    skip(" \t\r");
    return true;
  }

 private:
  void skip(const char* characters) {
    at_ = std::min(line_.find_first_not_of(characters, at_), line_.size());
  }

  std::string line_;
  std::size_t at_ = 0;
};

// "J20", also of J(2, 0).
std::string read_name(Reader& reader) {
  std::string name = reader.take_all(kOfNames);
  if (!reader.take("(")) return name;
  for (; !reader.is_at_end() && !reader.take(")"); reader.take(",")) name += reader.take_one();
  return name;
}

// The unit of the last digit. Throws Problem if there are too few digits.
double unit_of(const std::string& number, std::size_t column) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = std::min(number.find('.'), e);
  const int decimals = static_cast<int>(point < e ? e - point - 1 : 0);
  const int power = e < number.size() ? std::atoi(number.c_str() + e + 1) : 0;
  const std::string mantissa = number.substr(0, e);
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string::npos) return decimals < kDigits ? kExactly : std::pow(10, -decimals);
  if (std::count_if(mantissa.begin() + static_cast<long>(first), mantissa.end(), is_digit) <
      kDigits) {
    throw Problem(column,
                  "three digits or more are due, as 0.250 or 1.00; zeros in front don't "
                  "count");
  }
  return std::pow(10, power - decimals);
}

// "= 0.5", "= 45 deg" or the same with the sign of degrees.
Given read_value(Reader& reader, const Quantity& quantity, bool is_input) {
  if (!reader.take("=")) throw Problem(reader.column(), quantity.name + " needs a = and a number");
  Given given{&quantity, reader.column(), 0, 0};
  const std::string text = reader.take_all(kOfNumbers);
  char* end = nullptr;
  given.value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !std::isfinite(given.value)) {
    throw Problem(given.column, quantity.name + " needs a number here, as 0.25 or -1.50");
  }
  if (!is_input) given.unit = unit_of(text, given.column);
  if (quantity.name.rfind("theta", 0) == 0 && (reader.take("deg") || reader.take("\xc2\xb0"))) {
    given.value *= kDegree;
    given.unit *= kDegree;
  }
  if (!(quantity.least <= given.value && given.value <= quantity.most)) {
    std::ostringstream range;
    range << quantity.name << " has to be from " << quantity.least << " to " << quantity.most;
    throw Problem(given.column, range.str());
  }
  return given;
}

// Adds "y = 0.5", of one of these quantities that the part has.
void read_given(Reader& reader, const std::vector<Quantity>& quantities, int part,
                const std::string& due, std::vector<Given>& all) {
  const std::size_t begin = reader.column();
  const std::string name = read_name(reader);
  std::string names;
  for (const Quantity& quantity : quantities) {
    if (!std::count(quantity.parts.begin(), quantity.parts.end(), part)) continue;
    names += (names.empty() ? "" : ", ") + quantity.name;
    if (quantity.name != name) continue;
    for (const Given& other : all) {
      if (other.quantity == &quantity) throw Problem(begin, name + " is there twice: keep one");
    }
    all.push_back(read_value(reader, quantity, due[0] == '-'));
    reader.take(",");
    return;
  }
  throw Problem(begin, due + " of part " + std::to_string(part) + ": " + names);
}

// The case of a line; part 0 if it holds none. Throws Problem.
Case read_case(const std::string& line, const Table& table) {
  Reader reader(line);
  Case read;
  if (reader.is_at_end()) return read;
  const std::size_t begin = reader.column();
  if (reader.take("part")) read.part = std::atoi(reader.take_all(kOfNumbers).c_str());
  if (read.part < 1 || read.part > 3 || !reader.take(":")) {
    throw Problem(begin, "a case begins with part 1: or part 2: or part 3:");
  }
  while (!reader.take("->")) {
    if (reader.is_at_end()) {
      throw Problem(reader.column(),
                    "what must come out is missing: write -> and a name, = and a "
                    "number");
    }
    read_given(reader, table.inputs, read.part, "-> is due here, or an input", read.inputs);
  }
  do {
    read_given(reader, table.outputs, read.part, "due here is what comes out", read.outputs);
  } while (!reader.is_at_end());
  read.values = table.usual_values();
  for (const Given& given : read.inputs) read.values[given.quantity->place] = given.value;
  return read;
}

// ---- judging ----

constexpr std::size_t kLargest = 1 << 16;            // bytes of a file
constexpr std::size_t kMost = 100;                   // cases
constexpr double kRounding = 1e-6;                   // in units of the last digit
constexpr double kNudge = 1e-7, kContinuous = 1e-4;  // m or rad; and what may become of it

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
  const Quantity* input = undecided(table.right.at(asked.part), asked, table);
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
  const Values right = table.run(table.right.at(asked.part), asked.values);
  for (const Given& claim : asked.outputs) {
    if (agrees(right[claim.quantity->place], claim)) continue;
    verdict.sentence += (verdict.sentence.empty() ? "" : "; ") + claim.quantity->name + " " +
                        distance(right[claim.quantity->place], claim);
  }
  verdict.is_right = verdict.sentence.empty();
  for (const Program& program : table.wrong) {
    if (program.part != asked.part) continue;
    const bool answers_so = agrees(table.run(program, asked.values), asked);
    if (answers_so == verdict.is_right || undecided(program, asked, table)) continue;
    if (verdict.is_right) {
      verdict.caught.push_back(program.name);
    } else {
      verdict.sentence += "; buggy program " + program.name + " answers this";
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
    if (all.verdicts.size() == kMost && !Reader(line).is_at_end()) {
      all.verdicts.push_back({place, 0, false, {}, "only the first 100 cases are read"});
      break;
    }
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
  for (const Program& program : table.wrong) {
    (caught.count(program.name) ? all.caught : all.missed).push_back(program.name);
  }
  return all;
}

}  // namespace bounce::examples
