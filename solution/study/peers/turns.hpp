// Methods and peers at one setting each, timed in turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../starts.hpp"
#include "../timing.hpp"

namespace bounce::study {

// A point that takes longer than this runs only in some rounds, so that there are many rounds for
// the others.
inline constexpr double kLongNs = 5e7;
inline constexpr int kLongEvery = 4;

struct Point {
  std::string method, limit;
  bool is_peer;
  double setting;
  Errors error;
  const char* setting_is;
  std::function<double(long repeats)> time;  // of all repeats together, ns
  std::vector<double> ns = {};               // of one run, by round; NaN if it didn't run
};

// Fills `ns`. Every point is run once before it is timed.
void time_in_turns(std::vector<Point>& points, const Extent& extent);

struct Quartiles {
  double lower, median, upper;
};

// The times of one run, ns.
Quartiles times_of(const Point& point);

// The ratios within the rounds in which both ran.
Quartiles ratios_of(const Point& point, const Point& other);

}  // namespace bounce::study
