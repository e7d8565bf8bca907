// The questions of the study. Each returns one table.
#pragma once

#include <vector>

#include "../exact/scene.hpp"
#include "table.hpp"
#include "timing.hpp"

namespace bounce::study {

using namespace exact;

using Scenes = std::vector<Scene>;

// The truth itself at the sample times, with all its digits, for those who check it by other means.
Table truths(const Scenes& scenes);

// --- where methods fail ---

// The largest energy gain of an impact over (mu, epsilon), by law, and the epsilon below which
// theory allows Newton's law none.
Table energy_gain();
// How many solutions the contact problem may have over (alpha, mu), and mu* (alpha).
Table solution_count();
// Sweeps of projected Gauss-Seidel over the mass ratio, and what theory predicts; and the share of
// contacts over mu for which it never ends.
Table gauss_seidel_sweeps();
// How deep a fast square sinks, over v dt.
Table depth();
// The residual that an almost flat side leaves, over theta, by solver.
Table almost_flat();
// How fast a square turns that has just landed on a face, tilted by theta at first, by method.
Table flat_landing();
// Height and drift in ten seconds of rest, after each step, by method and dt.
Table rest_and_drift(const Scenes& scenes);
// The effect of scaling m and dt on solvers.
Table scaling();
// Examples with known answers: Kane's paradox, a leaning rectangle's limits, Painleve's.
Table examples();

// --- the least model ---

// The error of every model of the ladder in every scene, and the least model within 1 mm.
Table least_model(const Scenes& scenes, const Extent& extent);
// How many times as fast the simulator that chooses its model is as Moreau-Jean's scheme, which
// takes the whole model wherever a corner touches; and its largest distance to that.
Table chosen_model(const Scenes& scenes, const Extent& extent);
// Columns: chosen, least, scenes, chosen_wrong, largest_error_m. Of a thousand random scenes.
Table random_models();

// What simulate_to promises in `count` random scenes, and what it takes: how many it answers by
// which method and refuses, how often an error is larger than its bound, the bound over the error,
// and its time over that of the best choice once the truth is known (medians, and 90 in 100).
Table tolerance(int count);

}  // namespace bounce::study
