// The questions of the study. Each returns one table.
#pragma once

#include <vector>

#include "../exact/scene.hpp"
#include "table.hpp"
#include "timing.hpp"

namespace bounce::study {

using namespace exact;

using Scenes = std::vector<Scene>;

// Speed and error for every scene, method and setting. CPU time, the median of several rounds in
// which all methods take turns; ns per simulated second. A note says why a method does not get
// below 1 mm in a scene.
Table speed_accuracy(const Scenes& scenes, const Extent& extent);
// How many times as long as the assignment's scheme each method takes, with dt 0.001 s and
// tolerance 1e-6: the median of the ratios within a round, and their quartiles.
Table speed_ratios(const Scenes& scenes, const Extent& extent);
// The error over dt, halved again and again, and the order seen between two; empty where there is
// none, at the first and beside an error of 0.
Table order(const Scenes& scenes);
// The truth itself at the sample times, with all its digits, for those who check it by other means.
Table truths(const Scenes& scenes);
// The largest energy gain of an impact over (mu, epsilon), by law, and where theory allows one.
Table energy_gain(const Extent& extent);
// How many solutions the contact problem may have over (alpha, mu), and mu* (alpha).
Table solution_count();
// Sweeps of projected Gauss-Seidel over the mass ratio, and what theory predicts.
Table gauss_seidel_sweeps();
// How deep a fast square sinks, over v dt.
Table depth();
// The residual that an almost flat side leaves, over theta, by solver, and how often Lemke's method
// ends on a ray.
Table almost_flat();
// How fast a square turns that has just landed on a face, tilted by theta at first, by method.
Table flat_landing();
// Height and drift in ten seconds of rest, after each step, by method and dt.
Table rest_and_drift(const Scenes& scenes);
// The effect of scaling m and dt on solvers.
Table scaling();
// The effect of bad input without checks, and the messages of the checks.
Table bad_input(const Extent& extent);
// Single numbers that the pages name: Kane's paradox, Painleve's, and others.
Table examples();
// The error of every model of the ladder in every scene, and the least model within 1 mm.
Table least_model(const Scenes& scenes, const Extent& extent);
// What the simulator that chooses its model used, its distance to the whole model, and its gain.
Table chosen_model(const Scenes& scenes, const Extent& extent);
// Columns: chosen, least, scenes, chosen_wrong, largest_error_m. Of a thousand random scenes.
Table random_models();

// What simulate_to promises in random scenes, and what it takes: how many it answers by which
// method and refuses, how often an error is larger than its bound, the bound over the error, and
// its time over that of the best choice once the truth is known (medians, and 90 in 100).
Table tolerance(const Extent& extent);

}  // namespace bounce::study
