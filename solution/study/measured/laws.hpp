// Every law of impact that the measured impacts are compared with, from the smallest model on.
#pragma once

#include <span>
#include <string_view>

#include "methods/square.hpp"

namespace bounce::measured {

// An impact as measured. Arms in m, from the centre of mass to the corner that strikes and to the
// other corner of its side; impulses per mass, as everywhere in methods/.
struct Impact {
  double gyration_squared;  // r_g^2, m^2
  methods::Arm<double> corner, other;
  double v_x, v_y, omega;  // before, m/s and rad/s
  double after_x, after_y, after_omega;
};

struct Setting {
  double mu, epsilon, kappa;  // kappa: of the compliant law alone
};

struct Velocity {
  double x, y, omega;
};

using Law = Velocity (*)(const Impact&, const Setting&);

struct NamedLaw {
  std::string_view name;
  Law after;  // the velocity after the impact
};

std::span<const NamedLaw> laws();

// Throws std::invalid_argument for an unknown name.
Law law_named(std::string_view name);

}  // namespace bounce::measured
