#include "chart.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace bounce::study {
namespace {

constexpr std::string_view kData = "DATA";

std::string json(const Line& line) {
  Points finite;
  for (const auto& [x, y] : line.points) {
    if (std::isfinite(x) && std::isfinite(y)) finite.emplace_back(x, y);
  }
  return R"({"name":)" + quoted(line.name) + R"(,"kind":)" + quoted(line.kind) + R"(,"points":)" +
         list(finite,
              [](const auto& point) {
                return "[" + number_or_null(point.first) + "," + number_or_null(point.second) + "]";
              }) +
         "}";
}

std::string json(const Axis& axis) {
  return R"({"name":)" + quoted(axis.name) + R"(,"log":)" + (axis.logarithmic ? "true" : "false") +
         "}";
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += c == '<' ? "\\u003c" : std::string(1, c);
  }
  return json + "\"";
}

std::string number_or_null(double x) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.6g", x);
  return std::isfinite(x) ? digits : "null";
}

std::string json(const Chart& chart) {
  return R"({"id":)" + quoted(chart.id) + R"(,"title":)" + quoted(chart.title) + R"(,"x":)" +
         json(chart.x) + R"(,"y":)" + json(chart.y) + R"(,"sentence":)" + quoted(chart.sentence) +
         R"(,"lines":)" + list(chart.lines, [](const Line& line) { return json(line); }) + "}";
}

void write_page(const std::filesystem::path& file, std::string_view page, const std::string& data) {
  std::string html(page);
  html.replace(html.find(kData), kData.size(), data);
  if (!(std::ofstream(file, std::ios::binary) << html).flush()) {
    throw std::runtime_error(file.string() + " can't be written");
  }
}

}  // namespace bounce::study
