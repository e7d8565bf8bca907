// Methods and peers at one setting each, timed in turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../timing.hpp"

namespace bounce::study {

// What takes longer than this plays in every third round only, so that the rest has many.
inline constexpr double kLongNs = 5e7;
inline constexpr int kLongEvery = 3;

struct Point {
  std::string method, limit;
  bool is_peer;
  double setting, error;
  const char* setting_is;
  std::function<double(long repeats)> time;  // of all of them together, ns
  std::vector<double> ns = {};               // of one, by round; NaN where it didn't play
};

// Fills `ns`. Every point is run once before it is timed.
void time_in_turns(std::vector<Point>& points, const Extent& extent);

struct Quartiles {
  double lower, median, upper;
};

// Of one run, ns.
Quartiles times_of(const Point& point);

// Of the ratios within the rounds in which both played.
Quartiles ratios_of(const Point& point, const Point& other);

}  // namespace bounce::study
