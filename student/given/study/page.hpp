// Given: numbers as a reader wants them, and pages with what their scripts draw.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bounce::study {

using nlohmann::json;

// Three digits at most, as "%.3g" has them, or as `format` says; 120 and not 1.2e+02.
std::string number(double x, const char* format = "%.3g");

// Two digits, and commas: "80,000".
std::string rounded(double x);

// "1.2 mm": a number as above, and a unit that suits.
std::string length(double metres, const char* format = "%.3g");

using Points = std::vector<std::pair<double, double>>;

struct Axis {
  std::string name;  // with its unit
  bool logarithmic;  // what is 0 or below 1e-9 is drawn apart, below the axis
};

struct Line {
  std::string name;
  Points points;             // those that aren't finite are left out
  std::string kind = "own";  // "own" with dots, "other" thin with dots, "bound" without
};

struct Chart {
  std::string id, title;
  Axis x, y;
  std::vector<Line> lines;
  std::string sentence;  // what it shows, in words
};

void to_json(json& made, const Line& line);
void to_json(json& made, const Chart& chart);

// The page with the data in place of DATA, numbers that aren't finite as null.
inline std::string page_with(std::string_view page, const json& data) {
  const std::string_view place = "DATA";
  std::string text = data.dump(), html(page);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  return html.replace(html.find(place), place.size(), text);
}

// Writes that. Throws std::runtime_error, naming the file.
void write_page(const std::filesystem::path& file, std::string_view page, const json& data);

}  // namespace bounce::study
