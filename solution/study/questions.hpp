// The questions of the study; each answers with one table. Beside each, the page of the reference
// that it reproduces: nothing is copied from there, all is measured.
#pragma once

#include <vector>

#include "scene.hpp"
#include "table.hpp"

namespace bounce::study {

using Scenes = std::vector<Scene>;

// How fast, and how exact: every scene, method and setting. CPU time, the median of several rounds
// in which all methods take turns; ns per simulated second. A note says why a method does not get
// below 1 mm in a scene.
Table speed_accuracy(const Scenes& scenes);
// The error over dt, halved again and again, and the order seen between two.
Table order(const Scenes& scenes);
// The largest energy gain of an impact over (mu, epsilon), by law, and where theory allows one.
Table energy_gain();
// How many solutions the contact problem may have over (alpha, mu), and mu* (alpha).
Table solution_count();
// Sweeps of projected Gauss-Seidel over the mass ratio, and what theory predicts.
Table gauss_seidel_sweeps();
// How deep a fast square sinks, over v dt.
Table depth();
// The residual that an almost flat side leaves, over theta, by solver.
Table almost_flat();
// Height and drift after ten seconds of rest, by method and dt.
Table rest_and_drift(const Scenes& scenes);
// What scaling m and dt does to solvers.
Table scaling();
// The error of every model of the ladder in every scene, and the least model within 1 mm.
Table least_model(const Scenes& scenes);
// What the simulator that chooses its model used, its distance to the whole model, and its gain.
Table chosen_model(const Scenes& scenes);

}  // namespace bounce::study
