// Given: numbers as a reader wants them, and what a page's script draws, as JSON.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bounce::study {

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

std::string quoted(const std::string& text);
std::string number_or_null(double x);
std::string json(const std::vector<Line>& lines);
std::string json(const Chart& chart);

// {"name": value, ...}, of values that are JSON.
std::string object(const std::vector<std::pair<std::string, std::string>>& members);

// "[...]" of what `make` gives for each.
template <class All, class Make>
std::string list(const All& all, const Make& make) {
  std::string text;
  for (const auto& one : all) text += (text.empty() ? "" : ",\n") + make(one);
  return "[" + text + "]";
}

// Writes the page with DATA in its place. Throws std::runtime_error, naming the file.
void write_page(const std::filesystem::path& file, std::string_view page, const std::string& data);

}  // namespace bounce::study
