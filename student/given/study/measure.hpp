// Given: runs your parts, and measures how wrong, how fast and how stable they are.
#pragma once

#include "tables.hpp"

namespace bounce::study {

// delta as the scene has it, or in proportion to dt: 0.1 m/s times dt.
enum class Lift { fixed, scaled };

// One run of a scene. `error` is the largest distance to the truth over the samples, an angle
// counted as the way of a corner; infinite where the trajectory isn't finite or has another size.
struct Run {
  double dt;         // s
  double error;      // m
  double lcp_calls;  // time for a simulated second, in calls of solve_lcp
  double depth;      // how far the lowest corner was below the ground, m
};

// From dt = 0.02 s to 1e-5 s. `one_lcp` is the time of one call of solve_lcp, s.
std::vector<Run> runs(const Scene& scene, Lift lift, double one_lcp);

// The time of one call of solve_lcp with the handout's worked example, s.
double lcp_seconds();

struct Energy {
  std::vector<double> t, share;  // s; of the energy at the start
  double largest_gain;           // in one step, as a share
  double lift;                   // m g delta, which the lift adds to a step in contact, as a share
};
Energy energy(const Scene& scene, double dt, double seconds);

// A square that lies on its face, for ten seconds: how far it gets from where it lay, m.
struct Rest {
  double height, drift;
};
Rest rest(const Parameters& params, double dt, Lift lift);

}  // namespace bounce::study
