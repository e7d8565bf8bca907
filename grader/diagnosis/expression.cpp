#include <cctype>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Function = double (*)(double a, double b);

const std::map<std::string, Function> kFunctions{
    {"cos", [](double a, double) { return std::cos(a); }},
    {"sin", [](double a, double) { return std::sin(a); }},
    {"sqrt", [](double a, double) { return std::sqrt(a); }},
    {"abs", [](double a, double) { return std::abs(a); }},
    {"floor", [](double a, double) { return std::floor(a); }},
    {"round", [](double a, double) { return std::round(a); }},
    {"min", [](double a, double b) { return std::min(a, b); }},
    {"max", [](double a, double b) { return std::max(a, b); }},
    {"mod", [](double a, double b) { return a - b * std::floor(a / b); }},
    {"atan2", [](double y, double x) { return std::atan2(y, x); }},
    {"corner_x", [](double angle, double l) { return lowest_corner(angle, l).x(); }},
    {"corner_y", [](double angle, double l) { return lowest_corner(angle, l).y(); }}};

class Reader {
 public:
  Reader(const std::string& text, const Columns& columns)
      : rest_(text.c_str()), columns_(columns), size_(columns.at("l").size()) {}

  Column comparison() {
    const Column left = sum();
    if (take('<')) return (left < sum()).cast<double>();
    return take('=') ? are_same(left, sum()) : left;
  }

 private:
  static Column by(Function function, const Column& a, const Column& b) {
    return a.binaryExpr(b, function);
  }

  char next() {
    while (*rest_ == ' ') ++rest_;
    return *rest_;
  }

  bool take(char c) {
    if (next() != c) return false;
    ++rest_;
    return true;
  }

  bool is_name() { return std::isalnum(static_cast<unsigned char>(*rest_)) || *rest_ == '_'; }

  Column sum() {
    Column all = product();
    while (next() == '+' || next() == '-') all += *rest_++ == '+' ? product() : Column(-product());
    return all;
  }

  Column product() {
    Column all = power();
    while (next() == '/' || next() == '(' || is_name()) {
      all *= take('/') ? Column(1 / power()) : power();
    }
    return all;
  }

  Column power() {
    if (take('-')) return -power();
    const Column base = factor();
    return take('^') ? by(std::pow, base, factor()) : base;
  }

  Column factor() {
    if (next() == '(') return arguments().first;
    if (std::isdigit(static_cast<unsigned char>(*rest_))) {
      char* end = nullptr;
      const double number = std::strtod(rest_, &end);
      rest_ = end;
      return Column::Constant(size_, number);
    }
    std::string name;
    while (is_name()) name += *rest_++;
    const auto function = kFunctions.find(name);
    if (function == kFunctions.end()) return columns_.at(name);
    const auto [a, b] = arguments();
    return by(function->second, a, b);
  }

  // "(a)" or "(a, b)"
  std::pair<Column, Column> arguments() {
    take('(');
    Column a = comparison();
    Column b = take(',') ? comparison() : Column(Column::Zero(size_));
    if (!take(')')) throw std::logic_error(std::string("no end of a bracket: ") + rest_);
    return {a, b};
  }

  const char* rest_;
  const Columns& columns_;
  Eigen::Index size_;
};

}  // namespace

Column are_same(const Column& a, const Column& b) {
  return a.binaryExpr(b, [](double x, double y) { return same(x, y) ? 1.0 : 0.0; });
}

Column value(const std::string& formula, const Columns& columns) {
  return Reader(formula, columns).comparison();
}

double value_in(const Case& c, const std::string& formula) {
  return value(formula, columns_of(0, {c}, {{}}, {{}}))(0);
}

Eigen::Vector2d lowest_corner(double angle, double side) {
  const double c = std::cos(angle) * side / 2, s = std::sin(angle) * side / 2;
  // Down is along -c for one pair of sides and along -s for the other.
  const double along = s < 0 ? 1 : -1, aside = c < 0 ? 1 : -1;
  return {along * c - aside * s, along * s + aside * c};
}

}  // namespace bounce::tests
