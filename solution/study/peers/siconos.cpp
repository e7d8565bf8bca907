// Compares Siconos's solvers with ours on the LCP of part 2 alone: ns per LCP, and residual.
//
// The contacts slide, stick and separate; all get V and p of eqs. (9) and (10) as they are, and one
// of ours also a, b and c of the same contacts, which they are made of. Siconos is asked through
// its driver, with each solver's default options and z = 0 to begin with, and its options made
// once. Its methods that divide by the diagonal are left out, since the cone's entry is 0, and so
// is its Newton method, which gives up some of these contacts and prints as it does.
//
// Residual, m/s: with p_n = dt f_n / m, p_t = dt (f_t2 - f_t1) / m and w, v_t of one_corner.hpp,
//
//     max(|min(p_n, w)|, |p_t - clamp(p_t - v_t, -mu p_n, mu p_n)|),
//
// which is 0 for solutions only, whatever the solver says of itself.
#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <lcp_cst.h>

#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "../../methods/lemke.hpp"
#include "../../methods/one_corner.hpp"
#include "sweep.hpp"

namespace bounce::study {
namespace {

constexpr std::size_t kContacts = 256;
constexpr double kWrong = 1e-6;  // m/s; more than this is no solution

struct Contacts {
  Parameters params;
  std::vector<methods::OneCorner<double>> corners;
  std::vector<Lcp> lcps;

  Contacts() {
    for (std::size_t i = 0; i < kContacts; ++i) {
      const double x = double(i);
      const Jacobian J = get_contacts({0, 0.1, 0.37 * x}, params).J;
      const Vector3 v(3 * std::sin(x), -1.2 + std::sin(2 * x), 10 * std::sin(3 * x));
      lcps.push_back(form_lcp(J, v, params));
      corners.push_back(methods::one_corner<double>({J(2, 1), -J(2, 0)}, params.l * params.l / 6,
                                                    lcps[i].p(0), lcps[i].p(2), params.mu));
    }
  }
};

struct Impulse {
  double n, t;  // m/s
};

Impulse impulse_of(const Vector3& f, const Parameters& params) {
  const double per_force = params.dt / params.m;
  return {f(0) * per_force, (f(2) - f(1)) * per_force};
}

double residual_of(const methods::OneCorner<double>& k, const Impulse& p) {
  const double w = k.a * p.n + k.b * p.t + k.u_n, v_t = k.b * p.n + k.c * p.t + k.u_t;
  const double most = k.mu * std::max(p.n, 0.0);
  const double slip = p.t - std::clamp(p.t - v_t, -most, most);
  const double residual = std::max(std::abs(std::min(p.n, w)), std::abs(slip));
  return std::isnan(residual) ? std::numeric_limits<double>::infinity() : residual;
}

// The impulse of contact i; empty if the solver reports a failure.
using Solve = std::function<std::optional<Impulse>(const Contacts&, std::size_t i)>;

struct Solver {
  std::string name;
  Solve solve;
};

class SiconosSolver {
 public:
  explicit SiconosSolver(int id) : options_(solver_options_create(id), solver_options_delete) {}

  std::optional<Impulse> operator()(const Contacts& contacts, std::size_t i) const {
    Lcp lcp = contacts.lcps[i];  // both store by columns
    const std::unique_ptr<NumericsMatrix, NumericsMatrix* (*)(NumericsMatrix*)> V(
        NM_create_from_data(NM_DENSE, 4, 4, lcp.V.data()), NM_free_not_dense);
    LinearComplementarityProblem problem{4, V.get(), lcp.p.data()};
    Eigen::Vector4d z = Eigen::Vector4d::Zero(), w = lcp.p;
    const int failed = linearComplementarity_driver(&problem, z.data(), w.data(), options_.get());
    V->matrix0 = nullptr;
    if (failed != 0) return std::nullopt;
    return impulse_of(z.head<3>(), contacts.params);
  }

 private:
  std::shared_ptr<SolverOptions> options_;
};

// a, b, c, u and mu are entries of V and p, and the unknowns are forces.
Impulse solve_entries(const Lcp& lcp, const Parameters& params) {
  const Eigen::Matrix4d& V = lcp.V;
  const auto f = methods::solve_one_corner(
      methods::OneCorner<double>{V(0, 0), V(0, 2), V(2, 2), lcp.p(0), lcp.p(2), V(3, 0)});
  const double per_force = params.dt / params.m;
  return {f.n * per_force, f.t * per_force};
}

std::vector<Solver> all_solvers() {
  return {{"closed form, given V and p",
           [](const Contacts& contacts, std::size_t i) -> std::optional<Impulse> {
             return solve_entries(contacts.lcps[i], contacts.params);
           }},
          {"closed form, given a, b and c",
           [](const Contacts& contacts, std::size_t i) -> std::optional<Impulse> {
             const auto p = methods::solve_one_corner(contacts.corners[i]);
             return Impulse{p.n, p.t};
           }},
          {"Lemke, given to students",
           [](const Contacts& contacts, std::size_t i) -> std::optional<Impulse> {
             return impulse_of(solve_lcp(contacts.lcps[i].V, contacts.lcps[i].p), contacts.params);
           }},
          {"Siconos, lexicographic Lemke", SiconosSolver(SICONOS_LCP_LEMKE)},
          {"Siconos, pivoting", SiconosSolver(SICONOS_LCP_PIVOT)},
          {"Siconos, enumeration", SiconosSolver(SICONOS_LCP_ENUM)}};
}

struct Outcome {
  double residual = 0, difference = 0;  // the worst, m/s
  int refused = 0, wrong = 0;           // reported a failure; reported success wrongly
};

Outcome outcome_of(const Contacts& contacts, const Solver& solver) {
  Outcome outcome;
  for (std::size_t i = 0; i < kContacts; ++i) {
    const auto p = solver.solve(contacts, i);
    if (!p) {
      ++outcome.refused;
      continue;
    }
    const auto exact = methods::solve_one_corner(contacts.corners[i]);
    const double residual = residual_of(contacts.corners[i], *p);
    if (!(residual <= kWrong)) ++outcome.wrong;
    outcome.residual = std::max(outcome.residual, residual);
    outcome.difference =
        std::max({outcome.difference, std::abs(p->n - exact.n), std::abs(p->t - exact.t)});
  }
  return outcome;
}

// The time to solve all contacts `repeats` times, ns.
double time_of(const Contacts& contacts, const Solver& solver, long repeats) {
  double sum = 0;
  const double start = cpu_ns();
  for (long n = 0; n < repeats; ++n) {
    for (std::size_t i = 0; i < kContacts; ++i)
      sum += solver.solve(contacts, i).value_or(Impulse{}).n;
  }
  const double ns = cpu_ns() - start;
  return std::isnan(sum) ? std::numeric_limits<double>::infinity() : ns;
}

}  // namespace

Table lcp_solvers(const PeerExtent& extent) {
  Table table({"solver", "contacts", "ns_per_lcp", "lower_quartile", "upper_quartile", "ratio",
               "residual_m_per_s", "difference_m_per_s", "refused", "wrong"});
  const Contacts contacts;
  const std::vector<Solver> solvers = all_solvers();
  std::vector<Point> points;
  points.reserve(solvers.size());
  for (const Solver& solver : solvers) {
    points.push_back({solver.name, "", false, 0, {}, "", [&contacts, &solver](long repeats) {
                        return time_of(contacts, solver, repeats);
                      }});
  }
  time_in_turns(points, extent.timing);
  const double each = 1 / double(kContacts);
  for (std::size_t s = 0; s < solvers.size(); ++s) {
    const Outcome outcome = outcome_of(contacts, solvers[s]);
    const auto [lower, ns, upper] = times_of(points[s]);
    table.add(solvers[s].name, int(kContacts), ns * each, lower * each, upper * each,
              ratios_of(points[s], points[0]).median, outcome.residual, outcome.difference,
              outcome.refused, outcome.wrong);
  }
  return table;
}

}  // namespace bounce::study
