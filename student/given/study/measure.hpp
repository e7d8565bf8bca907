// Given: runs your parts, and measures how wrong and how fast they are.
#pragma once

#include <array>
#include <optional>

#include "tables.hpp"

namespace bounce::study {

// delta as the scene has it, or in proportion to dt: 0.1 m/s times dt.
enum class Lift { fixed, scaled };

// One run of a scene. `error` is the largest distance to the truth; infinite where the trajectory
// isn't finite or has another size.
struct Run {
  double dt;       // s
  double error;    // m
  double seconds;  // CPU time for a simulated second, s
};

// From dt = 0.02 s to 1e-5 s.
std::vector<Run> runs(const Scene& scene, Lift lift);

// What takes the square off the truth with this step, m: the causes, each alone as far as it takes
// it from where your own step does without all three; and as far as that is from the truth.
inline constexpr std::array kCauses{"flight", "time of impact", "delta", "anything else"};
std::array<double, 4> causes(const Scene& scene, double dt);

// The time of one call of solve_lcp with the handout's worked example, s.
double lcp_seconds();

// In how many steps of a run nothing touches, one corner does, or a second one as well.
std::array<int, 3> touches(const Scene& scene, double dt);

// Tries your parts where time steps fail. Of each trial its name in the page, what your parts do
// there, in a few words, and the lines of its chart. The page has the words that are always the
// same.
json trials(const Parameters& params);

// ---- for all that is measured ----

// The scene's parameters with about this step: n of them lie between two places of the truth.
struct Fitted {
  Parameters params;
  Eigen::Index n;
};
Fitted fit(const Scene& scene, double dt, Lift lift);

// The largest distance between two squares, an angle counted as the way of a corner.
double farthest(const std::vector<Vector3>& a, const std::vector<Vector3>& b, double l);

// The motion with this step and for this long. Empty where it isn't finite, or of another size.
std::optional<Trajectory> motion(const State& start, Parameters params, double dt, double seconds);

// The heights of the two lowest corners of the square at q, the lowest first, m.
std::array<double, 2> lowest_heights(const Vector3& q, double l);

// delta over dt where it is scaled, m/s.
inline constexpr double kShare = 0.1;

}  // namespace bounce::study
