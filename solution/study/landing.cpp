#include <cmath>

#include "../exact/event_driven.hpp"
#include "../methods/assignment.hpp"
#include "../methods/moreau_jean.hpp"
#include "catalog.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

using methods::Motion;

constexpr double kDrop = 0.2;      // m that the centre falls until a flat face lands
constexpr double kStep = 1e-4;     // s
constexpr double kLooking = 0.21;  // s; the face lands at 0.202 s, and again only at 0.4 s

Motion<double> dropped(const Parameters& params, double theta) {
  return {0, params.l / 2 + kDrop, theta, 0, 0, 0};
}

template <class Scheme>
double turning(Parameters params, double theta) {
  params.dt = kStep;
  Scheme scheme(params, dropped(params, theta));
  scheme.steps(std::lround(kLooking / kStep));
  return scheme.motion().omega;
}

double true_turning(const Parameters& params, double theta) {
  return simulate_events<double>(params, dropped(params, theta), {kLooking}, {}).at(0).omega;
}

}  // namespace

Table flat_landing() {
  Table table({"method", "theta_rad", "omega_rad_s"});
  const Parameters params;
  const auto add = [&](const char* name, const auto& omega_of) {
    for (const int sign : {-1, 1}) {
      for (int i = 16; i >= 1; --i) {
        const double theta = sign * std::pow(10.0, -i);
        table.add(name, theta, omega_of(params, theta));
      }
    }
    table.add(name, 0.0, omega_of(params, 0.0));
  };
  add("assignment", turning<methods::Assignment>);
  add("moreau_jean_1", turning<methods::MoreauJean<1>>);
  add("moreau_jean_2", turning<methods::MoreauJean<2>>);
  add("event_driven", true_turning);
  return table;
}

}  // namespace bounce::study
