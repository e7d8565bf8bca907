// Given: measured impacts, and what your form_lcp makes of them.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace bounce::real {

// An impact of one corner as it was measured; r points from the centre to the corner.
struct Impact {
  double r_x, r_y;        // m
  Vector3 before, after;  // v, in m/s, m/s, rad/s
};

// How far a law of impact is off, in the median over the impacts.
struct Law {
  double error;  // m/s
  std::string name;
};

struct Measured {
  Parameters params;  // mu and epsilon fitted to other impacts of the same square; without gravity
  double floor;       // what no impulse at the corner can get below, in the median, m/s
  Law assignment;     // the law of part 2, by the course's solution
  std::vector<Law> others;
  std::vector<Impact> impacts;
};

// From fixtures/measured.txt. Throws std::runtime_error, naming the file.
Measured read_measured(const std::filesystem::path& file);

// What follows from your form_lcp for one impact.
struct Answer {
  Vector3 after;  // v, in m/s, m/s, rad/s
  double error;   // m/s; infinite where there is none
};

struct Result {
  std::vector<Answer> answers;  // to each impact
  double error;                 // the median, m/s; infinite where more than half have no solution
  int no_solution;              // impacts for which solve_lcp finds none to your V and p
};

// Asks form_lcp for each impact, and compares the velocity that follows with the measured one. The
// error is sqrt(dv_x^2 + dv_y^2 + r_g^2 domega^2), r_g^2 = l^2/6: the metric of the energy.
Result ask(const Measured& measured);

}  // namespace bounce::real
