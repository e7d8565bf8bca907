// Judges a contact's forces by their residual, and by a second solution, in closed form, case by
// case.
#pragma once

#include "random_contacts.hpp"

namespace bounce::tests {

// The sizes that velocities and forces of a problem are counted in: p, and what V makes of it.
struct Units {
  double velocity, force;
};

Units units(const Lcp& lcp);

// max_i |min(z_i, w_i)|, each in its unit, as a part of the largest sum of terms that makes a w_i:
// rounding grows with that sum. The sum counts up to a million times p, so that no huge answer that
// has nothing to do with p is accepted.
double residual(const Lcp& lcp, const Vector4d& z, const Units& unit);

// The solver keeps lambda to itself. The lambdas that suit f are an interval; if it isn't empty, it
// starts at 0 or where a w_i is 0, so these are tried.
double residual(const Lcp& lcp, const Vector3& f, const Units& unit);

enum Mode { separates, sticks, slides_left, slides_right };

struct ContactForces {
  Mode mode;
  double f_n, f;  // f = f_t2 - f_t1 is the friction along t
};

// Unique while a > mu |b|, that is while mu < 4/3 for a square.
ContactForces by_cases(const Numbers& n);

// v_{t+1}, eq. (13), with l omega in place of omega, so that all three are m/s.
Vector3 velocity_after(const Scene& scene, double f_n, double f);

}  // namespace bounce::tests
