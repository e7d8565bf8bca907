#include "cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace bounce::examples {
namespace {

constexpr int kDigits = 3;
constexpr double kDegree = 0.017453292519943295;
constexpr double kExactly = 1e-9;  // how near to a plain 0 counts as 0
constexpr const char* kOfNames = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_'";
constexpr const char* kOfNumbers = "0123456789.eE+-";

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
      throw Problem(column(),
                    "a number has a point and no comma, as 0.5; behind a comma that stands "
                    "between two there is a blank");
    }
    skip(" \t\r");
    return taken;
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
  const std::string name = reader.take_all(kOfNames);
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

}  // namespace

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

}  // namespace bounce::examples
