// alike --part N [--given] --count K -- COMMAND...
//
// Asks the runner that COMMAND starts K random questions of part N, and prints one JSON object:
//   {"asked": K, "differing": n}
// where n answers differ from the solution's by more than rounding. The questions range far wider
// than the fixtures' do, and all are decidable: right programs answer them alike.
// Exit status 3, with a sentence on standard error, when it fails itself.
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <cmath>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../../../../grader/judge/session.hpp"
#include "../../../../solution/fixtures/decidable.hpp"
#include "../../../../solution/fixtures/random_numbers.hpp"
#include "../../../parts/cases.hpp"
#include "../../../parts/submission.hpp"

namespace bounce {

std::vector<std::filesystem::path> tests::fixture_folders() { return {}; }
void tests::about_to_ask(const Case&) {}
std::string tests::in_words(const Case& c, const Problem& problem) { return summary(c, problem); }

namespace {

using fixtures::RandomNumbers;

constexpr double kTolerance = 1e-9;             // of max(1, |expected|), as the checks have it
constexpr double kAlongATrajectory = 1e-6;      // rounding grows from step to step
constexpr std::size_t kMostTrials = 1'000'000;  // for one question that is decidable

bool close(const Eigen::MatrixXd& expected, const Eigen::MatrixXd& got, double tolerance) {
  const Eigen::ArrayXXd room = tolerance * expected.array().abs().max(1.0);
  return ((got - expected).array().abs() <= room).all();  // NaN isn't close
}

// --- questions: empty where the one that was drawn is undecidable; else whether it is answered
// as the solution answers it ---

double power_of_ten(RandomNumbers& draw, double low, double high) {
  return std::pow(10.0, draw.between(low, high));
}

// The assignment's, others in its neighbourhood, others far away, and the ends of what is possible.
Parameters any_parameters(RandomNumbers& draw) {
  const int kind = draw.below(4);
  if (kind == 0) return Parameters();
  if (kind == 1) return draw.other_parameters();
  Parameters params;
  const double decades = kind == 2 ? 1.5 : 4;
  params.l = power_of_ten(draw, -decades, decades);
  params.m = power_of_ten(draw, -decades, decades);
  params.mu = draw.below(4) == 0 ? 0 : draw.between(0.01, 1.3);
  params.epsilon = draw.below(4) == 0 ? draw.below(2) : draw.between(0, 1);
  params.g = Vector3(draw.either_sign(0, 10), draw.between(-15, 5), draw.either_sign(0, 5));
  if (draw.below(8) == 0) params.g.setZero();
  params.dt = power_of_ten(draw, kind == 2 ? -3.5 : -7, kind == 2 ? -1 : 0);
  params.delta = params.l * power_of_ten(draw, -3, -1);
  return params;
}

double any_angle(RandomNumbers& draw) {
  return draw.either_sign(0, draw.below(2) == 0 ? 4 : 1000, 6);
}

Vector3 any_velocity(RandomNumbers& draw) {
  const int kind = draw.below(8);
  const double slow = -draw.between(1, 5);
  if (kind == 0) {
    return {draw.over_decades(slow, slow + 1), draw.over_decades(slow, slow + 1),
            draw.over_decades(slow, slow + 1)};
  }
  const double spin = kind < 3 ? 300 : 10;
  return {draw.either_sign(0, 4), draw.either_sign(0, 4), draw.either_sign(0, spin)};
}

// Deep in the ground, about the threshold of contact, or above it.
Vector3 any_configuration(RandomNumbers& draw, const Parameters& params) {
  Vector3 q(draw.either_sign(0, 10), 0, any_angle(draw));
  const int kind = draw.below(4);
  const double phi = kind == 0   ? params.delta * draw.between(0, 4, 6)
                     : kind == 1 ? draw.between(0, 2, 6)
                                 : -params.l * draw.between(0, 1.5, 6);
  q(1) = phi - get_contacts(q, params).phi;
  return q;
}

// The solver may refuse a question that no right program can answer either.
bool decidable(const State& s, const Parameters& params) {
  try {
    return fixtures::mode_of_step(s.q, s.v, params, 1e-7).has_value();
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::optional<bool> same_contact(RandomNumbers& draw) {
  const Parameters params = any_parameters(draw);
  const Vector3 q = any_configuration(draw, params);
  if (fixtures::corner_gap(q, params) < 1e-6) return std::nullopt;
  const Contact expected = get_contacts(q, params), got = submission::get_contacts(q, params);
  return close(expected.J, got.J, kTolerance) && std::abs(got.phi - expected.phi) <= kTolerance;
}

std::optional<bool> same_lcp(RandomNumbers& draw) {
  const Parameters params = any_parameters(draw);
  Jacobian J = get_contacts(any_configuration(draw, params), params).J;
  if (draw.below(2) == 0) {
    const bool small = draw.below(2) == 0;
    for (double& x : J.reshaped()) x = small ? draw.over_decades(-4, 0) : draw.either_sign(0, 2, 6);
  }
  const Vector3 v = any_velocity(draw);
  const Lcp expected = form_lcp(J, v, params), got = submission::form_lcp(J, v, params);
  return close(expected.V, got.V, kTolerance) && close(expected.p, got.p, kTolerance);
}

std::optional<bool> same_step(RandomNumbers& draw) {
  const Parameters params = any_parameters(draw);
  const Vector3 q = any_configuration(draw, params), v = any_velocity(draw);
  if (!decidable({q, v}, params)) return std::nullopt;
  const State expected = step(q, v, params), got = submission::step(q, v, params);
  return close(expected.q, got.q, kTolerance) && close(expected.v, got.v, kTolerance);
}

std::optional<bool> same_trajectory(RandomNumbers& draw) {
  Parameters params = any_parameters(draw);
  params.T = 1 + draw.below(12);
  const Vector3 q = any_configuration(draw, params), v = any_velocity(draw);
  State state{q, v};
  for (int t = 1; t < params.T; ++t) {
    if (!decidable(state, params)) return std::nullopt;
    state = step(state.q, state.v, params);
  }
  const Trajectory expected = simulate(q, v, params);
  const Trajectory got = submission::simulate(q, v, params);
  return close(expected.q, got.q, kAlongATrajectory) && close(expected.v, got.v, kAlongATrajectory);
}

std::optional<bool> same(std::uint32_t part, RandomNumbers& draw) {
  switch (part) {
    case 1:
      return same_contact(draw);
    case 2:
      return same_lcp(draw);
    case 3:
      return same_step(draw);
    default:
      return same_trajectory(draw);
  }
}

bool differs(std::uint32_t part, RandomNumbers& draw) {
  for (std::size_t trial = 0; trial < kMostTrials; ++trial) {
    if (const std::optional<bool> found = same(part, draw)) return !*found;
  }
  throw std::logic_error("no decidable question was found");
}

// --- the command ---

struct Options {
  std::uint32_t part = 0;
  bool given = false;
  int count = 0;
  std::vector<std::string> command;
};

Options read_options(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size() && options.command.empty(); ++i) {
    if (words[i] == "--part") options.part = static_cast<std::uint32_t>(std::stoul(words.at(++i)));
    if (words[i] == "--given") options.given = true;
    if (words[i] == "--count") options.count = std::stoi(words.at(++i));
    if (words[i] == "--") {
      options.command.assign(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
    }
  }
  if (options.part < 1 || options.part > 4 || options.count < 1 || options.command.empty()) {
    throw std::runtime_error("usage: alike --part N [--given] --count K -- COMMAND...");
  }
  return options;
}

int run(const Options& options) {
  judge::Limits limits;
  limits.cpu_seconds = 60;
  limits.wall_seconds = 600;
  judge::Session asked(options.command, limits, options.part, options.given);
  judge::session = &asked;
  RandomNumbers draw("alike");
  int differing = 0;
  for (int i = 0; i < options.count; ++i) {
    try {
      differing += differs(options.part, draw);
    } catch (const tests::Ended&) {  // nothing more is answered
      differing += options.count - i;
      break;
    } catch (const std::runtime_error&) {  // the program threw
      ++differing;
    }
  }
  std::cout << nlohmann::json{{"asked", options.count}, {"differing", differing}} << std::endl;
  return 0;
}

}  // namespace
}  // namespace bounce

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);  // that a runner has ended is noticed by reading from it
  bounce::judge::stay_on_this_cpu();
  return bounce::run(bounce::read_options({argv + 1, argv + argc}));
} catch (const std::exception& e) {
  std::cerr << "alike: " << e.what() << std::endl;
  return 3;
}
