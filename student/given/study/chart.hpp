// Given: what a page's script draws, as JSON.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bounce::study {

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
std::string json(const Chart& chart);

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
