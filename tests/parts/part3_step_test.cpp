// Part 3: step. Each check is a fact about one time step, eqs. (11) to (14).
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "answers.hpp"
#include "checks.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

State ask_step(Asker& asker, const Case& c) { return submission::step(asker, c.q, c.v, c.params); }

Problem compare_velocity(const Case& c, const State& got) {
  return compare(c, "v after the step", kVelocity, c.state.v, got.v);
}

Problem compare_step(const Case& c, const State& got) {
  return both(compare_velocity(c, got),
              compare(c, "q after the step", kConfiguration, c.state.q, got.q));
}

constexpr std::size_t kSteps = 8;

// A chain of the submission's own steps, and then each of them asked again, the last one first.
// What it answers must not depend on what it was asked before: a scheme that needs the step before,
// or a contact that is kept, answers otherwise out of the chain.
struct Chain {
  std::array<State, kSteps> from;
  std::array<std::optional<State>, kSteps> in_the_chain, alone;  // empty where it throws
  bool is_decided = true;  // as where recorded answers don't hold what it asks
};

bool is_finite(const State& s) { return s.q.allFinite() && s.v.allFinite(); }

std::optional<State> ask_step_of_chain(Asker& asker, const Case& c, const State& from) {
  try {
    return submission::step(asker, from.q, from.v, c.params);
  } catch (const std::exception&) {
    return {};
  }
}

// From a step that is no state, as a wrong one may lead to, the chain begins anew.
Chain ask_chain(Asker& asker, const Case& c) {
  Chain chain;
  chain.from[0] = {c.q, c.v};
  chain.in_the_chain[0] = ask_step(asker, c);
  for (std::size_t t = 1; t < kSteps; ++t) {
    const std::optional<State>& last = chain.in_the_chain[t - 1];
    chain.from[t] = last && is_finite(*last) ? *last : chain.from[0];
    chain.in_the_chain[t] = ask_step_of_chain(asker, c, chain.from[t]);
  }
  for (std::size_t t = kSteps; t-- > 0;)
    chain.alone[t] = ask_step_of_chain(asker, c, chain.from[t]);
  chain.is_decided = !asker.was_undecided();
  return chain;
}

// A step that throws, or is no number, says nothing: other checks see that it is wrong.
bool differs(const Case& c, const std::optional<State>& in, const std::optional<State>& alone) {
  if (!in || !is_finite(*in)) return false;
  return !alone || !compare(c, "v", kVelocity, in->v, alone->v).empty() ||
         !compare(c, "q", kConfiguration, in->q, alone->q).empty();
}

Problem compare_chain(const Case& c, const Chain& chain) {
  Problem problem;
  problem.is_open = !chain.is_decided;
  for (std::size_t t = 0; t < kSteps && chain.is_decided; ++t) {
    if (!differs(c, chain.in_the_chain[t], chain.alone[t])) continue;
    problem.sentence = "step " + std::to_string(t + 1) +
                       " of a run is different when it is computed on its own: does your program "
                       "keep something from one call to the next?";
    break;
  }
  return problem;
}

// Judged with the velocity that was returned, so that a wrong velocity costs no more points.
// Expected is the part of q' - q that doesn't come from the new velocity: 0 or (0, delta, 0).
Problem compare_move(const Case& c, const Chain& chain) {
  const State& got = *chain.in_the_chain[0];
  const bool contact = (c.state.q - c.q - c.params.dt * c.state.v).y() > c.params.delta / 2;
  const Vector3 lift(0, contact ? c.params.delta : 0, 0);
  // Where steps are followed, phi is near delta.
  const Problem wrong = c.has_decidable_steps
                            ? Problem()
                            : compare(c, "q' - q - dt v', the lift", kConfiguration, lift,
                                      got.q - c.q - c.params.dt * got.v);
  return wrong.empty() ? compare_chain(c, chain) : wrong;
}

[[maybe_unused]] const bool kPart3IsAdded =
    register_call(3,
                  [](Asker& asker, const Case& c) { return numbers_of(ask_step(asker, c), c); }) &&
    add_checks<State>("part3", ask_step,
                      {{"FallsFreely", compare_velocity},
                       {"BouncesAndSticks", compare_velocity},
                       {"BouncesAndSlides", compare_velocity},
                       {"LetsACornerGo", compare_velocity},
                       {"TouchesBelowDelta", compare_velocity}}) &&
    add_checks<Chain>("part3", ask_chain, {{"MovesWithTheNewVelocity", compare_move}}, true) &&
    add_checks<State>("part3", ask_step, {{"TakesEveryNumberFromTheParameters", compare_step}});

}  // namespace
}  // namespace bounce::tests
