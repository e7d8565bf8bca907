// Part 3: step. Each test is a fact about one time step, eqs. (11) to (14).
#include <gtest/gtest.h>

#include <utility>

#include "answers.hpp"
#include "cases.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

State step_of(const Case& c) { return submission::step(c.q, c.v, c.params); }

Problem compare_velocity(const Case& c, const State& got) {
  return compare(c, "v after the step", kVelocity, c.state.v, got.v);
}

Problem compare_velocity(const Case& c) { return compare_velocity(c, step_of(c)); }

[[maybe_unused]] const bool kPart3IsRegistered =
    register_call(3, [](const Case& c) { return numbers_of(step_of(c), c); });

TEST(part3, FallsFreely) { for_each_case(compare_velocity); }

TEST(part3, BouncesAndSticks) { for_each_case(compare_velocity); }

TEST(part3, BouncesAndSlides) { for_each_case(compare_velocity); }

TEST(part3, LetsACornerGo) { for_each_case(compare_velocity); }

TEST(part3, TouchesBelowDelta) { for_each_case(compare_velocity); }

constexpr int kChain = 8;  // steps

// Follows the submission's own steps, and then asks each of them again, the last one first. What
// it answers must not depend on what it was asked before: a scheme that needs the step before, or
// a contact that is kept, answers otherwise out of the chain.
Problem compare_chain(const Case& c) {
  std::vector<State> chain{{c.q, c.v}};
  try {
    while (chain.size() <= kChain) {
      const State next = submission::step(chain.back().q, chain.back().v, c.params);
      if (!next.q.allFinite() || !next.v.allFinite()) break;
      chain.push_back(next);
    }
  } catch (const std::exception&) {
    // A wrong step may lead to where the next one throws; other checks see that it is wrong.
  }
  if (std::exchange(asked_what_is_not_recorded, false)) chain.resize(1);
  for (std::size_t t = chain.size() - 1; t > 0; --t) {
    const State alone = submission::step(chain[t - 1].q, chain[t - 1].v, c.params);
    const Problem wrong = both(compare(c, "v, asked again", kVelocity, chain[t].v, alone.v),
                               compare(c, "q, asked again", kConfiguration, chain[t].q, alone.q));
    if (!wrong.empty()) {
      return {"step " + std::to_string(t) +
                  " of a chain is another one when it is asked out of the chain: is something "
                  "kept from one call to the next?",
              {}};
    }
  }
  return {};
}

// Judged with the velocity that was returned, so that a wrong velocity costs no more points.
// Expected is the part of q' - q that doesn't come from the new velocity: 0 or (0, delta, 0).
TEST(part3, MovesWithTheNewVelocity) {
  for_each_case([](const Case& c) {
    if (c.has_decidable_steps) return Problem();  // followed below; phi is near delta
    const bool contact = (c.state.q - c.q - c.params.dt * c.state.v).y() > c.params.delta / 2;
    const Vector3 lift(0, contact ? c.params.delta : 0, 0);
    const State got = step_of(c);
    return compare(c, "q' - q - dt v', the lift", kConfiguration, lift,
                   got.q - c.q - c.params.dt * got.v);
  });
  for_each_case_once(compare_chain);
}

TEST(part3, TakesEveryNumberFromTheParameters) {
  for_each_case([](const Case& c) {
    const State got = step_of(c);
    return both(compare_velocity(c, got),
                compare(c, "q after the step", kConfiguration, c.state.q, got.q));
  });
}

}  // namespace
}  // namespace bounce::tests
