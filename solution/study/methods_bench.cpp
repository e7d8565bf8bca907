// kit_methods_bench: what one step, one LCP and one second of each method cost, by Google
// Benchmark. Counters: ns_each is the time of one step; residual is that of an LCP's answer, m/s.
#include <benchmark/benchmark.h>

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>

#include "../methods/assignment_fast.hpp"
#include "../methods/gauss_seidel.hpp"
#include "../methods/lemke.hpp"
#include "../methods/moreau_jean.hpp"
#include "../methods/penalty.hpp"
#include "catalog.hpp"

namespace bounce::study {
namespace {

using methods::Arm;
using methods::Motion;

constexpr long kSteps = 1000;

void per_item(benchmark::State& state, double items) {
  state.counters["ns_each"] = benchmark::Counter(
      items * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// Without restitution and with a small delta, a square that slides down a slope sinks in, so that
// every step has a contact.
Parameters contact_parameters() {
  Parameters params;
  params.epsilon = 0;
  params.delta = 1e-4;
  params.g = Vector3(5, -9.81, 0);
  return params;
}
const Motion<double> kContact{0, 0.1, 0, 0, 0, 0};
const Motion<double> kFlight{0, 1e9, 0.3, 0.5, 0, 0};
const Motion<double> kRest{0, 0.1, 0, 0, 0, 0};

template <class Scheme>
void steps(benchmark::State& state, const Parameters& params, const Motion<double>& start) {
  for ([[maybe_unused]] auto _ : state) {
    Scheme scheme(params, start);
    scheme.steps(kSteps);
    benchmark::DoNotOptimize(scheme.motion());
  }
  per_item(state, kSteps);
}

void solution_step(benchmark::State& state) {
  const Parameters params = contact_parameters();
  const State start = methods::state_of(kContact);
  for ([[maybe_unused]] auto _ : state) {
    State s = start;
    for (long i = 0; i < kSteps; ++i) s = step(s.q, s.v, params);
    benchmark::DoNotOptimize(s);
  }
  per_item(state, kSteps);
}

// --- the LCP alone: contacts of a square that slides, sticks or leaves, one after the other ---

struct Contacts {
  static constexpr std::size_t kCount = 256;
  std::vector<methods::OneCorner<double>> corners;
  std::vector<Lcp> lcps;

  Contacts() {
    for (std::size_t i = 0; i < kCount; ++i) {
      const double x = double(i);
      const Parameters params;
      const Jacobian J = get_contacts({0, 0.1, 0.37 * x}, params).J;
      const Vector3 v(3 * std::sin(x), -1.2 + std::sin(2 * x), 10 * std::sin(3 * x));
      lcps.push_back(form_lcp(J, v, params));
      corners.push_back(methods::one_corner<double>({J(2, 1), -J(2, 0)}, params.l * params.l / 6,
                                                    lcps[i].p(0), lcps[i].p(2), params.mu));
    }
  }
};

double residual_of(const methods::OneCorner<double>& k, double n, double t) {
  const double w = k.a * n + k.b * t + k.u_n;
  return std::abs(std::min(n, w));
}

template <class Solve>
void one_corner(benchmark::State& state, const Solve& solve) {
  const Contacts contacts;
  double worst = 0;
  for (std::size_t i = 0; i < Contacts::kCount; ++i) {
    const auto [n, t] = solve(contacts, i);
    worst = std::max(worst, residual_of(contacts.corners[i], n, t));
  }
  for ([[maybe_unused]] auto _ : state)
    for (std::size_t i = 0; i < Contacts::kCount; ++i) benchmark::DoNotOptimize(solve(contacts, i));
  per_item(state, double(Contacts::kCount));
  state.counters["residual"] = worst;
}

using Impulse = std::pair<double, double>;
constexpr double kPerForce = 0.01 / 0.3;  // dt / m

void closed_form(benchmark::State& state) {
  one_corner(state, [](const Contacts& contacts, std::size_t i) -> Impulse {
    const auto p = methods::solve_one_corner(contacts.corners[i]);
    return {p.n, p.t};
  });
}

void given_lemke(benchmark::State& state) {
  one_corner(state, [](const Contacts& contacts, std::size_t i) -> Impulse {
    const Vector3 f = solve_lcp(contacts.lcps[i].V, contacts.lcps[i].p);
    return {f(0) * kPerForce, (f(2) - f(1)) * kPerForce};
  });
}

void plain_lemke(benchmark::State& state) {
  one_corner(state, [](const Contacts& contacts, std::size_t i) -> Impulse {
    const auto f = methods::lemke(contacts.lcps[i].V, contacts.lcps[i].p).z;
    return {f(0) * kPerForce, (f(2) - f(1)) * kPerForce};
  });
}

void swept(benchmark::State& state) {
  one_corner(state, [](const Contacts& contacts, std::size_t i) -> Impulse {
    const auto& k = contacts.corners[i];
    Eigen::Matrix2d G;
    G << k.a, k.b, k.b, k.c;
    const auto p = methods::gauss_seidel(G, Eigen::Vector2d(k.u_n, k.u_t), k.mu, 1e-12, 100'000).p;
    return {p(0), p(1)};
  });
}

// --- two corners of a flat side ---

struct FlatSide {
  methods::TwoCorners<double> merged;
  methods::Lcp8 literal;
};

FlatSide flat_side() {
  const Parameters params;
  const auto r = methods::arms(params.l / 2, 1.0, 0.0);
  const auto jacobian = [](const Arm<double>& arm) {
    Jacobian J;
    J << Vector3(1, 0, -arm.y), Vector3(0, 1, arm.x);
    return J;
  };
  const methods::Lcp8 lcp =
      methods::form_lcp8(jacobian(r[2]), jacobian(r[3]), {1, -1, 0.5}, params);
  return {methods::two_corners<double>(r[2], r[3], params.l * params.l / 6, {lcp.p(0), lcp.p(4)},
                                       lcp.p(2), params.mu),
          lcp};
}

void merged_rows(benchmark::State& state) {
  FlatSide side = flat_side();
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(side.merged);
    benchmark::DoNotOptimize(methods::solve_two_corners(side.merged));
  }
  per_item(state, 1);
  state.counters["residual"] = methods::solve_two_corners(side.merged).violation;
}

void lemke_8x8(benchmark::State& state) {
  const FlatSide side = flat_side();
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(methods::lemke(side.literal.V, side.literal.p));
  per_item(state, 1);
  state.counters["residual"] = methods::lcp_residual(
      side.literal.V, side.literal.p, methods::lemke(side.literal.V, side.literal.p).z);
}

template <class Scheme>
void add_scheme(const std::string& name) {
  const auto add = [&](const char* phase, const Parameters& params, const Motion<double>& start) {
    benchmark::RegisterBenchmark((name + ", " + phase).c_str(), [params, start](auto& state) {
      steps<Scheme>(state, params, start);
    });
  };
  add("contact", contact_parameters(), kContact);
  add("flight", Parameters(), kFlight);
  add("rest", Parameters(), kRest);
}

void add_all() {
  benchmark::RegisterBenchmark("step: the solution's, contact", solution_step);
  add_scheme<methods::Assignment>("step: assignment");
  add_scheme<methods::AssignmentFast>("step: assignment_fast");
  add_scheme<methods::MoreauJean<1>>("step: moreau_jean_1");
  add_scheme<methods::MoreauJean<2>>("step: moreau_jean_2");
  add_scheme<methods::Penalty>("step: penalty");
  benchmark::RegisterBenchmark("LCP: closed form", closed_form);
  benchmark::RegisterBenchmark("LCP: Lemke, given", given_lemke);
  benchmark::RegisterBenchmark("LCP: Lemke, plain", plain_lemke);
  benchmark::RegisterBenchmark("LCP: projected Gauss-Seidel", swept);
  benchmark::RegisterBenchmark("LCP of a side: merged rows, closed form", merged_rows);
  benchmark::RegisterBenchmark("LCP of a side: 8x8, Lemke", lemke_8x8);
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  bounce::study::add_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
