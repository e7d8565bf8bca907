#include "numbers.hpp"

#include <cmath>
#include <cstdio>

namespace bounce::study {

std::string number(double x, const char* format) {
  char text[40];
  const bool is_large = x >= 100 && x < 1e6;
  std::snprintf(text, sizeof text, is_large ? "%.0f" : format, x);
  return text;
}

std::string rounded(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  std::string text = std::to_string(std::llround(std::round(x / unit) * unit));
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string length(double metres) {
  if (metres >= 1) return number(metres) + " m";
  if (metres >= 1e-2) return number(metres * 100) + " cm";
  if (metres >= 1e-4) return number(metres * 1000) + " mm";
  if (metres >= 1e-8) return number(metres * 1e6) + " \xc2\xb5m";
  return metres > 0 ? "less than 0.01 \xc2\xb5m" : "0";
}

}  // namespace bounce::study
