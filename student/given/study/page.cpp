#include "page.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace bounce::study {
namespace {

std::string printed(double x, const char* format) {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

json axis(const Axis& axis) { return {{"name", axis.name}, {"log", axis.logarithmic}}; }

}  // namespace

std::string number(double x, const char* format) {
  return printed(x, x >= 100 && x < 1e6 ? "%.0f" : format);
}

std::string rounded(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  std::string text = printed(std::round(x / unit) * unit, "%.0f");
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string length(double metres, const char* format) {
  if (metres >= 1) return number(metres, format) + " m";
  if (metres >= 1e-2) return number(metres * 100, format) + " cm";
  if (metres >= 1e-4) return number(metres * 1000, format) + " mm";
  if (metres >= 1e-8) return number(metres * 1e6, format) + " \xc2\xb5m";
  return metres > 0 ? "less than 0.01 \xc2\xb5m" : "0";
}

void to_json(json& made, const Line& line) {
  made = {{"name", line.name}, {"kind", line.kind}, {"points", json::array()}};
  for (const auto& [x, y] : line.points) {
    if (std::isfinite(x) && std::isfinite(y)) made["points"].push_back({x, y});
  }
}

void to_json(json& made, const Chart& chart) {
  made = {{"id", chart.id},     {"title", chart.title},       {"x", axis(chart.x)},
          {"y", axis(chart.y)}, {"sentence", chart.sentence}, {"lines", chart.lines}};
}

void write_page(const std::filesystem::path& file, std::string_view page, const json& data) {
  if (!(std::ofstream(file, std::ios::binary) << page_with(page, data)).flush()) {
    throw std::runtime_error(file.string() + " can't be written");
  }
}

}  // namespace bounce::study
