// The questions of the study. Each returns one table, some of the scenes, some of random ones.
#pragma once

#include "../exact/scene.hpp"
#include "table.hpp"
#include "timing.hpp"

namespace bounce::study {

using Question = Table(const Scenes&, const Extent&);

// The truth itself at the sample times, with all its digits, for those who check it by other means.
Question truths;
// How many impacts each scene has while it is compared, what the square does at the end, and from
// when on it is still, s, if it is.
Question endings;

// Time and error of every method, and of every engine that was built in, in every scene: the chart
// of speed against accuracy. A row for each scene, method and setting: the step, s, or a tolerance.
// All of a scene take turns, and a time is the median of the rounds, in ns of CPU per simulated
// second. own_error_m is that of the scene's own start, which the handout compares with.
Question speed_accuracy;

// --- where methods fail ---

// The largest energy gain of an impact over (mu, epsilon), by law, and the epsilon below which
// theory allows Newton's law none.
Question energy_gain;
// How many solutions the contact problem may have over (alpha, mu), and mu* (alpha).
Question solution_count;
// Sweeps of projected Gauss-Seidel over the mass ratio, and what theory predicts; and the share of
// contacts over mu for which it never ends.
Question gauss_seidel_sweeps;
// How deep a fast square sinks, over v dt.
Question depth;
// The residual that an almost flat side leaves, over theta, by solver.
Question almost_flat;
// How fast a square turns that has just landed on a face, tilted by theta at first, by method.
Question flat_landing;
// Examples with known answers: Kane's paradox, a leaning rectangle's limits, Painleve's.
Question examples;

// --- where methods fail in time ---

// Height and drift in ten seconds of rest, after each step, by method and dt.
Question rest_and_drift;
// How far off a square is that was at rest on a slope, m, and how much energy a tumbling one gains
// that should keep it, as a share, by method and dt.
Question slope_and_energy;
// The restitution that each method and engine really gives, over dt, on a face and on a corner: the
// least and the most over starts that are parts of a step apart.
Question restitution;
// How many random throws are off by more than 1 mm after 0.3 s, over mu, by method and dt.
Question large_friction;
// How far the event-driven method in double is from the truth, m, and its impacts: where bounces
// accumulate, over epsilon; tumbling without a loss, over the time, s; balancing on a corner, over
// the angle from the balance, rad.
Question event_limits;

// --- the least model ---

// The error of every model of the ladder in every scene, and the least model within 1 mm.
Question least_model;
// How many times as fast the simulator that chooses its model is as Moreau-Jean's scheme, which
// takes the whole model wherever a corner touches; and its largest distance to that.
Question chosen_model;
// Columns: chosen, least, scenes, chosen_wrong, largest_error_m. Of a thousand random scenes.
Question random_models;

// What simulate_to promises in random scenes, and what it takes: how many it answers by which
// method and refuses, how often an error is larger than its bound, the bound over the error, and
// its time over that of the best choice once the truth is known (medians, and 90 in 100).
Question tolerance;

}  // namespace bounce::study
