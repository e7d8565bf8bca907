// Given: numbers as a reader wants them, and pages with what their scripts draw.
#pragma once

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../check/files.hpp"
#include "paths.hpp"  // which CMakeLists.txt makes

namespace bounce::study {

using nlohmann::json;

inline std::string printed(double x, const char* format) {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

// Three digits at most, as "%.3g" has them, or as `format` says; 120 and not 1.2e+02.
inline std::string number(double x, const char* format = "%.3g") {
  return printed(x, x >= 100 && x < 1e6 ? "%.0f" : format);
}

// Two digits, and commas: "80,000".
inline std::string rounded(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  std::string text = printed(std::round(x / unit) * unit, "%.0f");
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

// "1.2 mm": a number as above, and a unit that suits.
inline std::string length(double metres, const char* format = "%.3g") {
  if (metres >= 1) return number(metres, format) + " m";
  if (metres >= 1e-2) return number(metres * 100, format) + " cm";
  if (metres >= 1e-4) return number(metres * 1000, format) + " mm";
  if (metres >= 1e-8) return number(metres * 1e6, format) + " \xc2\xb5m";
  return metres > 0 ? "less than 0.01 \xc2\xb5m" : "0";
}

// A line of a chart, without the points that aren't finite: "own" with dots, "other" thin with
// dots, "bound" without.
using Points = std::vector<std::pair<double, double>>;
inline json line(const std::string& name, const Points& points, const std::string& kind = "own") {
  json line{{"name", name}, {"kind", kind}, {"points", json::array()}};
  for (const auto& [x, y] : points) {
    if (std::isfinite(x) && std::isfinite(y)) line["points"].push_back({x, y});
  }
  return line;
}

// A page of the folder page/, with the data in place of DATA, numbers that aren't finite as null. A
// line @NAME@ of it stands for the file of that name beside it, a style, a script or a piece of
// HTML, so that the page is one file. Throws Failure.
inline std::string page_with(const std::string& name, const json& data) {
  const std::filesystem::path folder = std::filesystem::path(BOUNCE_HOME) / "given" / "page";
  std::string html;
  for (const std::string& line : check::lines_of(check::read(folder / name))) {
    const bool names_file = line.size() > 2 && line.front() == '@' && line.back() == '@';
    html += names_file ? check::read(folder / line.substr(1, line.size() - 2)) : line + "\n";
  }
  const std::string place = "DATA";
  if (!check::has(html, place)) {
    throw check::Failure("given/page/" + name + " is missing: unpack the handout again");
  }
  std::string text = data.dump();
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  return html.replace(html.find(place), place.size(), text);
}

}  // namespace bounce::study
