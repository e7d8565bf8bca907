#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "../methods/assignment.hpp"
#include "../methods/lemke.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Given {
  Parameters params;
  State start{{0, 0.15, 0.1}, {0, 0, 0}};
};

struct Spoilt {
  const char* input;
  std::function<void(Given&)> spoil;
};

// Writes NaN without its sign, which means nothing.
std::string words(double x) {
  if (std::isnan(x)) return "NaN";
  std::ostringstream text;
  text.precision(3);
  text << x;
  return text.str();
}

// What the assignment's scheme makes of the input in a hundred steps, without a check.
std::string unchecked(const Given& given) {
  methods::Assignment scheme(given.params, methods::motion_of<double>(given.start));
  scheme.steps(100);
  const auto s = scheme.motion();
  std::ostringstream text;
  text << "no error; after a hundred steps y = " << words(s.y) << " m, v_y = " << words(s.v_y)
       << " m/s";
  return text.str();
}

std::string checked(const Given& given) {
  try {
    check(given.params, given.start);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "accepted";
}

std::string lemke_on_nan() {
  const Parameters params;
  Jacobian J;
  J << 1, 0, 0, 1, 0.1, 0;
  methods::Lcp8 lcp = methods::form_lcp8(J, J, {1, -1, 0}, params);
  lcp.p(0) = kNan;
  const methods::LemkeResult z = methods::lemke(lcp.V, lcp.p);
  std::ostringstream text;
  text << "Lemke says " << (z.end == methods::LemkeEnd::solved ? "\"solved\"" : "\"not solved\"");
  text << "; the residual is " << methods::lcp_residual(lcp.V, lcp.p, z.z) << " m/s";
  return text.str();
}

// How many times as long a step with contact takes if every velocity is denormal. Each step is the
// first of its square, since a corner that leaves is not pressed again.
double denormal_cost(const Extent& extent) {
  Parameters params;
  params.g.setZero();
  const auto contacts = [&](double speed) {
    return Job{[params, speed] {
      double left = 0;
      for (int i = 0; i < 10'000; ++i) {
        methods::Assignment scheme(params, {0, 0, 0.3, speed, -speed, speed});
        scheme.steps(1);
        left += scheme.motion().v_y;
      }
      if (std::isnan(left)) throw std::logic_error("no number");
    }};
  };
  std::vector<Job> jobs{contacts(1e-310), contacts(1e-3)};
  time_in_turn(jobs, extent);
  return quantile(ratios(jobs[0], jobs[1]));
}

std::string denormal_words(const Extent& extent) {
  std::ostringstream text;
  text.precision(3);
  text << "no error; a step with a contact takes " << denormal_cost(extent) << " times as long";
  return text.str();
}

}  // namespace

Table bad_input(const Extent& extent) {
  const Spoilt all[] = {
      {"y is NaN", [](Given& x) { x.start.q(1) = kNan; }},
      {"v_x is infinite", [](Given& x) { x.start.v(0) = std::numeric_limits<double>::infinity(); }},
      {"theta is 3e9 rad", [](Given& x) { x.start.q(2) = 3e9; }},
      {"the start is below the ground", [](Given& x) { x.start.q(1) = -1; }},
      {"mu is -0.3", [](Given& x) { x.params.mu = -0.3; }},
      {"epsilon is 1.5", [](Given& x) { x.params.epsilon = 1.5; }},
      {"m is 0", [](Given& x) { x.params.m = 0; }},
      {"l is 0", [](Given& x) { x.params.l = 0; }},
      {"dt is 0", [](Given& x) { x.params.dt = 0; }},
      {"dt is -0.01 s", [](Given& x) { x.params.dt = -0.01; }},
  };
  Table table({"input", "unchecked", "checked"});
  for (const auto& [input, spoil] : all) {
    Given given;
    spoil(given);
    table.add(input, unchecked(given), checked(given));
  }
  Given many;
  many.params.T = 2'000'000'000;
  table.add("T is two billion", "the columns are asked for, whatever memory there is",
            checked(many));
  Given denormal;
  denormal.start.v(0) = 1e-310;
  table.add("v is denormal, 1e-310", denormal_words(extent), checked(denormal));
  table.add("NaN in p of an LCP", lemke_on_nan(), "the solvers' residual, where NaN is infinite");
  return table;
}

}  // namespace bounce::study
