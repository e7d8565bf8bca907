// A simulator that uses the least model that each step needs, and reports which.
//
// The scheme is Moreau-Jean's (../methods/moreau_jean.hpp). For each step it climbs a ladder of
// models, until one provably gives the same as the whole model:
//
//   asleep          Both low corners are in contact, and the step before began and ended at rest.
//                   Gravity doesn't change, so neither will anything else: all other columns are
//                   copies.
//   ballistic       No corner can touch at the middle of the next n steps, which are done in closed
//                   form. n is the number of steps with y > rho, or else the number within the time
//                   in which no corner can reach the ground (safe_step of first_root.hpp).
//   one_normal      One corner touches, and the height of the second is positive. Friction is left
//                   out where mu is 0, where the corner doesn't slide after the normal impulse (p_t
//                   = 0 solves the LCP then), or where mu p_n is too small to matter until the end.
//   one_friction    One corner, with friction.
//   two_normals     Two corners, friction left out for the same reasons.
//   two_frictions   Two corners with friction: the whole model.
#pragma once

#include <array>

#include "scene.hpp"

namespace bounce::study {

// The steps that took each level.
using ModelReport = std::array<long, kModelLevels>;

// params.T columns, of a scene as read_scene gives it or with other steps.
Trajectory simulate_scene(const Parameters& params, const State& start,
                          ModelReport* report = nullptr);

}  // namespace bounce::study
