#include "expression.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace bounce::tests {
namespace {

using Function = double (*)(double a, double b, double l);

const std::map<std::string, Function> kFunctions{
    {"cos", [](double a, double, double) { return std::cos(a); }},
    {"sin", [](double a, double, double) { return std::sin(a); }},
    {"sqrt", [](double a, double, double) { return std::sqrt(a); }},
    {"abs", [](double a, double, double) { return std::abs(a); }},
    {"round", [](double a, double, double) { return std::round(a); }},
    {"min", [](double a, double b, double) { return std::min(a, b); }},
    {"max", [](double a, double b, double) { return std::max(a, b); }},
    {"corner_x", [](double a, double, double l) { return lowest_corner(a, l).x; }},
    {"corner_y", [](double a, double, double l) { return lowest_corner(a, l).y; }}};

bool is_of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

class Reader {
 public:
  Reader(const char* text, const Symbols& symbols) : rest_(text), symbols_(symbols) {}

  double sum() {
    double all = product();
    while (next() == '+' || next() == '-') all += *rest_++ == '+' ? product() : -product();
    return all;
  }

 private:
  char next() {
    while (*rest_ == ' ') ++rest_;
    return *rest_;
  }

  bool take(char c) {
    if (next() != c) return false;
    ++rest_;
    return true;
  }

  double product() {
    double all = power();
    while (next() == '/' || next() == '(' || is_of_a_name(next()))
      all *= take('/') ? 1 / power() : power();
    return all;
  }

  double power() {
    if (take('-')) return -power();
    const double base = factor();
    return take('^') ? std::pow(base, factor()) : base;
  }

  double factor() {
    if (next() == '(') return arguments().first;
    if (!is_of_a_name(next())) throw std::logic_error(std::string("no formula: ") + rest_);
    if (std::isdigit(static_cast<unsigned char>(*rest_))) {
      char* end = nullptr;
      const double number = std::strtod(rest_, &end);
      rest_ = end;
      return number;
    }
    std::string name;
    while (is_of_a_name(*rest_)) name += *rest_++;
    const auto function = kFunctions.find(name);
    if (function == kFunctions.end()) return symbols_.at(name);
    const auto [a, b] = arguments();
    return function->second(a, b, symbols_.at("l"));
  }

  // "(a)" or "(a, b)"
  std::pair<double, double> arguments() {
    take('(');
    const double a = sum();
    const double b = take(',') ? sum() : 0;
    if (!take(')')) throw std::logic_error(std::string("no end of a bracket: ") + rest_);
    return {a, b};
  }

  const char* rest_;
  const Symbols& symbols_;
};

}  // namespace

double value(const std::string& formula, const Symbols& symbols) {
  return Reader(formula.c_str(), symbols).sum();
}

Corner lowest_corner(double angle, double side) {
  const double c = std::cos(angle) * side / 2, s = std::sin(angle) * side / 2;
  // Down is along -c for one pair of sides and along -s for the other.
  const double along = s < 0 ? 1 : -1, aside = c < 0 ? 1 : -1;
  return {along * c - aside * s, along * s + aside * c};
}

}  // namespace bounce::tests
