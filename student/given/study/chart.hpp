// Given: a chart as SVG, with its sentence below.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bounce::study {

struct Line {
  std::string name;
  std::vector<std::pair<double, double>> points;  // those that aren't finite are left out
  bool is_own;                                    // thick, with dots
};

struct Bar {
  std::string name, label;  // the label says the value, with its unit
  double value;             // infinite where there is none
  bool is_own;
};

struct Axes {
  std::string x, y;  // with units
  bool logarithmic;  // both, or none
};

// HTML. Where a logarithmic axis can't show a number, as 0, it stands at its lower end.
std::string chart(const std::string& title, const Axes& axes, const std::vector<Line>& lines,
                  const std::string& sentence);

// HTML. Horizontal bars from 0; one that is longer than `most` is cut there, and says so.
std::string bars(const std::string& title, const std::vector<Bar>& rows, double most,
                 const std::string& sentence);

}  // namespace bounce::study
