// The schemes: what each gets right, and its typical failures.
#include <gtest/gtest.h>

#include <algorithm>
#include <bounce/part3_step.hpp>

#include "cases.hpp"
#include "methods/assignment.hpp"
#include "methods/impact_laws.hpp"
#include "methods/moreau_jean.hpp"
#include "methods/penalty.hpp"
#include "study/catalog.hpp"

namespace bounce::study::tests {
namespace {

template <class Scheme>
Motion<double> after(const Parameters& params, const Motion<double>& start, double seconds) {
  return sample(Scheme(params), start, 1, std::lround(seconds / params.dt)).back();
}

Parameters with_dt(double dt) {
  Parameters params;
  params.dt = dt;
  return params;
}

double error(const std::string& method, const Scene& scene, double setting) {
  const auto all = all_methods();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](auto& m) { return m.name == method; });
  return error_of(scene, found->simulate(scene, setting, kSamples), truth_of(scene));
}

// --- every scheme ---

// The error in a scene falls with the step, or stays where one of the scheme's rules is too coarse.
TEST(schemes, ConvergeWithOrderOneOrStayAtAFloor) {
  struct Row {
    const char *method, *scene;
    double coarse, fine, least, most;  // settings, and the ratio of their errors
  };
  const Row rows[] = {
      {"assignment", "slide", 1e-4, 1e-5, 0.9, 1.1},  // a fixed delta
      {"assignment", "pointed_drop", 1e-4, 1e-5, 0.9, 1.1},
      {"assignment_delta_dt", "slide", 1e-3, 1e-5, 5, 1e9},
      {"assignment_delta_dt", "pointed_drop", 1e-3, 1e-5, 5, 1e9},
      {"moreau_jean_1", "oblique_bounce", 1e-3, 1e-5, 10, 1e9},
      {"moreau_jean_1", "flat_drop", 1e-3, 1e-5, 0.3, 3},  // one corner takes what two should share
  };
  for (const Row& row : rows) {
    const Scene scene = scene_named(row.scene);
    const double ratio = error(row.method, scene, row.coarse) / error(row.method, scene, row.fine);
    EXPECT_GE(ratio, row.least) << row.method << ", " << row.scene;
    EXPECT_LE(ratio, row.most) << row.method << ", " << row.scene;
  }
  for (const Scene& scene : scenes()) {
    if (scene.name == "ten_seconds") continue;  // magnifies the error of any step beyond use
    const double fine = error("moreau_jean_2", scene, 1e-6);
    EXPECT_LE(fine, 2e-4) << scene.name;
    EXPECT_LE(fine, error("moreau_jean_2", scene, 2e-3) / 10 + 1e-9) << scene.name;
    EXPECT_LE(error("event_driven", scene, 1e-12), 1e-6) << scene.name;
  }
}

// --- the assignment's ---

double apart(const State& one, const State& other) {
  return std::max((one.q - other.q).norm() / (1 + one.q.norm()),
                  (one.v - other.v).norm() / (1 + one.v.norm()));
}

// Rounding differs, and impacts of squares that spin fast make more of it: so over a few steps,
// from wherever the solution is.
TEST(assignment, IsTheSolutionsStep) {
  Random random(1);
  int contacts = 0;
  for (int i = 0; i < 500; ++i) {
    const Case c = ordinary_case(random, i, 0.9);
    State state = state_of(c.start);
    for (int n = 0; n < 40; ++n) {
      const auto start = motion_of(state);
      for (int k = 0; k < 3; ++k) state = step(state.q, state.v, c.params);
      contacts += lowest_gap(start, Body<double>(c.params)) < 0;
      ASSERT_LE(apart(state_of(after<Assignment>(c.params, start, 3 * c.params.dt)), state), 1e-11)
          << i << " " << n;
    }
  }
  EXPECT_GT(contacts, 1000) << "of the starts are in contact";
}

// --- Moreau and Jean's ---

// The square turns about one corner until its neighbour lands; the impact is one of both.
TEST(moreau_jean, SharesALandingWithTheCornerThatIsHeldWhateverTheStep) {
  const Scene scene = scene_named("tilted_settling");
  for (int i = 0; i <= 10; ++i) {
    const double dt = 5e-6 * std::pow(10, -i / 20.0);
    EXPECT_LE(error("moreau_jean_2", scene, dt), 3 * dt) << dt;
  }
}

TEST(moreau_jean, LeavesACornerThatLeavesAlone) {
  const Motion<double> start{0, 0.12, 0.3, 0, 0.02, 0};  // 5 mm below the ground
  for (const double epsilon : {0.0, 1.0}) {
    Parameters params = with_dt(1e-3);
    params.epsilon = epsilon;
    const double v_y = start.v_y - 1e-3 * 9.81;
    EXPECT_EQ(after<MoreauJean<1>>(params, start, 1e-3).v_y, v_y);
    EXPECT_EQ(after<MoreauJean<2>>(params, start, 1e-3).v_y, v_y);
  }
}

TEST(moreau_jean, GainsNoEnergyBelowTheLimit) {
  Random random(4);
  for (int i = 0; i < 5000; ++i) {
    Case c = ordinary_case(random, i, 0.7);
    c.params.dt = 5e-3;
    const Body<double> body(c.params);
    const double before = energy(c.start, body);
    const double now = energy(after<MoreauJean<2>>(c.params, c.start, 0.5), body);
    ASSERT_LE(now, before + 1e-9 * (1 + std::abs(before))) << i;
  }
}

// --- springs and dampers ---

// An impact of a corner that leans, by what it does to the spin.
TEST(penalty, ComesNearerToStrongesLawThanToNewtonsWhereFrictionTurnsTheSquare) {
  Parameters params = with_dt(1e-7);
  params.g.setZero();
  const Body<double> body(params);
  for (const double theta : {0.3, 0.6}) {
    const auto lowest = lowest_arm(body.half, std::cos(theta), std::sin(theta));
    const Motion<double> start{0, -lowest.y, theta, 1, -1, 5};
    const auto omega = [&](ImpactLaw law) {
      Motion<double> s = start;
      const auto p = impact(collision_of(s, lowest, body), law);
      apply_impulse(s, lowest, p.n, p.t, body.gyration_squared);
      return s.omega;
    };
    const double found = after<Penalty>(params, start, 2e-3).omega;
    EXPECT_LT(std::abs(found - omega(ImpactLaw::stronge)),
              std::abs(found - omega(ImpactLaw::newton)) / 4)
        << theta;
  }
}

}  // namespace
}  // namespace bounce::study::tests
