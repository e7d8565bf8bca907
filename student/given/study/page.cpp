#include "page.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace bounce::study {
namespace {

constexpr std::string_view kData = "DATA";

std::string printed(double x, const char* format) {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

std::string of_line(const Line& line) {
  Points finite;
  for (const auto& [x, y] : line.points) {
    if (std::isfinite(x) && std::isfinite(y)) finite.emplace_back(x, y);
  }
  const auto pair = [](const auto& point) {
    return "[" + number_or_null(point.first) + "," + number_or_null(point.second) + "]";
  };
  return object(
      {{"name", quoted(line.name)}, {"kind", quoted(line.kind)}, {"points", list(finite, pair)}});
}

std::string json(const Axis& axis) {
  return object({{"name", quoted(axis.name)}, {"log", axis.logarithmic ? "true" : "false"}});
}

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

std::string quoted(const std::string& text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += c == '<' ? "\\u003c" : std::string(1, c);
  }
  return json + "\"";
}

std::string number_or_null(double x) { return std::isfinite(x) ? printed(x, "%.6g") : "null"; }

std::string object(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string text;
  for (const auto& [name, value] : members) {
    text += (text.empty() ? "" : ",") + quoted(name) + ":" + value;
  }
  return "{" + text + "}";
}

std::string json(const std::vector<Line>& lines) { return list(lines, of_line); }

std::string json(const Chart& chart) {
  return object({{"id", quoted(chart.id)},
                 {"title", quoted(chart.title)},
                 {"x", json(chart.x)},
                 {"y", json(chart.y)},
                 {"sentence", quoted(chart.sentence)},
                 {"lines", json(chart.lines)}});
}

void write_page(const std::filesystem::path& file, std::string_view page, const std::string& data) {
  std::string html(page);
  html.replace(html.find(kData), kData.size(), data);
  if (!(std::ofstream(file, std::ios::binary) << html).flush()) {
    throw std::runtime_error(file.string() + " can't be written");
  }
}

}  // namespace bounce::study
