#include <algorithm>
#include <cmath>

#include "formula.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

// Gravity's part of v', by what dt g is multiplied by.
std::vector<Value> gravity_in_v(const Asked& a) {
  const double m = a.c.params.m, dt = a.c.params.dt;
  return {{"", 1},
          {"without gravity", 0},
          {"with twice gravity", 2},
          {"with gravity upwards", -1},
          {"with gravity not multiplied by dt", 1 / dt},
          {"with gravity multiplied by dt^2", dt},
          {"with half of gravity", 0.5},
          {"with m g in place of g", m},
          {"with g / m in place of g", 1 / m}};
}

std::vector<Value> force_factors(const Asked& a) {
  const double m = a.c.params.m, l = a.c.params.l, dt = a.c.params.dt, inertia = m * l * l / 6;
  return {{"1", 1},
          {"0", 0},
          {"-1", -1},
          {"2", 2},
          {"1/2", 0.5},
          {"1/dt", 1 / dt},
          {"dt", dt},
          {"m", m},
          {"m^2", m * m},
          {"m r_g^2", inertia},
          {"(m r_g^2)^2", inertia * inertia},
          {"r_g^2", l * l / 6},
          {"mu", a.c.params.mu},
          {"epsilon", a.c.params.epsilon}};
}

// A component of what forces and the given multiple of gravity leave of v' - v.
double without_gravity(const Asked& a, const Eigen::VectorXd& numbers, double gravity, Index i) {
  return numbers(3 + i) - a.c.v(i) - gravity * a.c.params.dt * a.c.params.g(i);
}

bool is_velocity_right(const std::vector<Asked>& all) {
  return is_right(all, 3) && is_right(all, 4) && is_right(all, 5);
}

// What a number that is written down may stand for.
std::vector<Value> written_factors(const Asked& a) {
  const double m = a.c.params.m, l = a.c.params.l;
  return {{"l^2 / ", l * l}, {"m / ", m}, {"m l^2 / ", m * l * l}};
}

// "l^2 / 0.16", if the component's change is the right one times this. Empty if none fits.
std::string by_a_written_number(const std::vector<Asked>& all, const std::vector<double>& change,
                                Index i) {
  for (const Formula& factor : in_all(all, written_factors)) {
    std::vector<double> due;
    for (std::size_t k = 0; k < all.size(); ++k)
      due.push_back(factor.values[k] * without_gravity(all[k], all[k].right, 1, i));
    std::size_t largest = 0;
    for (std::size_t k = 1; k < due.size(); ++k)
      if (std::abs(due[k]) > std::abs(due[largest])) largest = k;
    const double number = due[largest] / change[largest];
    std::size_t k = 0;
    while (k < due.size() && same(due[k] / number, change[k])) ++k;
    if (std::isfinite(number) && k == due.size()) return factor.words + digits(number);
  }
  return "";
}

// By what the forces' change of each component of v is multiplied: "(1, 1, 0)". Empty if by nothing
// that is known.
std::string force_words(const std::vector<Asked>& all, const Formula& gravity) {
  Words words;
  for (Index i = 0; i < 3; ++i) {
    std::vector<Formula> formulas = in_all(all, force_factors);
    std::vector<double> change;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double right = without_gravity(all[k], all[k].right, 1, i);
      for (Formula& formula : formulas) formula.values[k] *= right;
      change.push_back(without_gravity(all[k], all[k].got, gravity.values[k], i));
    }
    words.push_back(fitting(formulas, change));
    if (words.back().empty()) words.back() = by_a_written_number(all, change, i);
    if (words.back().empty() || words.back()[0] == 'e') return "";
  }
  return "(" + joined(words, ", ") + ")";
}

// Whether gravity alone makes v', with this factor.
bool falls_with(const std::vector<Asked>& all, const Formula& gravity) {
  constexpr double kNone = 1e-9;
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (Index i = 0; i < 3; ++i) {
      if (!(std::abs(without_gravity(all[k], all[k].got, gravity.values[k], i)) <= kNone)) {
        return false;
      }
    }
  }
  return true;
}

void add_velocity(Words& sentences, const std::vector<Asked>& all, const std::string& where,
                  bool touches) {
  if (all.size() < kEnough || is_velocity_right(all)) return;
  Words found;
  for (const Formula& gravity : in_all(all, gravity_in_v)) {
    const std::string words = where + " your v' is that " + gravity.words;
    if (!touches) {
      if (falls_with(all, gravity)) found.push_back(words + ".");
      continue;
    }
    const std::string forces = force_words(all, gravity);
    if (forces.empty()) continue;
    found.push_back(forces == "(1, 1, 1)"
                        ? words + "."
                        : words + (gravity.words.empty() ? "" : ", and ") +
                              "with the forces' change of (v_x, v_y, omega) multiplied by " +
                              forces + ".");
  }
  if (found.size() == 1) sentences.push_back(found[0]);
}

// --- the forces and their moment ---

// What forces change of v: (v_x, v_y, omega), with f_n and f_t of the right v' times these factors.
struct ForcesChange {
  double v_x, v_y, omega;
};

ForcesChange of_forces(const Asked& a, double normal, double tangential) {
  const auto [r_x, r_y] = lowest_corner(a.c.q(2), a.c.params.l);
  const double m = a.c.params.m, inertia = a.c.params.M()(2, 2);
  const double f_n = normal * m * without_gravity(a, a.right, 1, 1);
  const double f_t = tangential * m * without_gravity(a, a.right, 1, 0);
  return {f_t / m, f_n / m, (r_x * f_n - r_y * f_t) / inertia};
}

bool changes_like(const Asked& a, const ForcesChange& change) {
  return same(without_gravity(a, a.got, 1, 0), change.v_x) &&
         same(without_gravity(a, a.got, 1, 1), change.v_y) &&
         same(without_gravity(a, a.got, 1, 2), change.omega);
}

// Where f_n or f_t is multiplied by something, and the moment follows them.
void add_forces(Words& sentences, const std::vector<Asked>& touching) {
  if (touching.size() < kEnough) return;
  Words found;
  const std::vector<Formula> factors = in_all(touching, force_factors);
  for (const Formula& normal : factors) {
    for (const Formula& tangential : factors) {
      std::size_t k = 0;
      while (k < touching.size() &&
             changes_like(touching[k],
                          of_forces(touching[k], normal.values[k], tangential.values[k]))) {
        ++k;
      }
      if (k < touching.size()) continue;
      found.push_back("Where a corner touches, your v' is that with f_n multiplied by " +
                      normal.words + " and f_t by " + tangential.words + ".");
    }
  }
  if (found.size() == 1) sentences.push_back(found[0]);
}

// What f_n, or f_t, may be multiplied by in the moment.
std::vector<Value> moment_arms(const Asked& a) {
  const auto [r_x, r_y] = lowest_corner(a.c.q(2), a.c.params.l);
  return {{"0", 0}, {"r_x ", r_x}, {"-r_x ", -r_x}, {"r_y ", r_y}, {"-r_y ", -r_y}};
}

// Where v_x' and v_y' tell the forces and omega' doesn't fit them: the moment that omega' fits.
void add_moment(Words& sentences, const std::vector<Asked>& touching) {
  if (!is_right(touching, 3) || !is_right(touching, 4) || is_right(touching, 5)) return;
  std::vector<double> moment;
  for (const Asked& a : touching)
    moment.push_back(a.c.params.M()(2, 2) * without_gravity(a, a.got, 1, 2));
  const std::vector<Formula> arms = in_all(touching, moment_arms);
  std::vector<Formula> sums;
  for (const Formula& normal : arms) {
    for (const Formula& tangential : arms) {
      Formula moments{sum(product(normal.words, "f_n"), product(tangential.words, "f_t")), {}};
      for (std::size_t k = 0; k < touching.size(); ++k) {
        const Asked& a = touching[k];
        const double f_n = a.c.params.m * without_gravity(a, a.right, 1, 1);
        const double f_t = a.c.params.m * without_gravity(a, a.right, 1, 0);
        moments.values.push_back(normal.values[k] * f_n + tangential.values[k] * f_t);
      }
      sums.push_back(moments);
    }
  }
  add_formula(sentences, "Where a corner touches, the moment of your forces, by omega',",
              fitting(sums, moment));
}

}  // namespace

Words formulas_of_new_velocity(const std::vector<Asked>& touching,
                               const std::vector<Asked>& flying) {
  Words sentences;
  add_velocity(sentences, touching, "Where a corner touches,", true);
  if (sentences.empty() && !is_velocity_right(touching)) add_forces(sentences, touching);
  if (sentences.empty()) add_moment(sentences, touching);
  add_velocity(sentences, flying, "In flight,", false);
  return sentences;
}

}  // namespace bounce::tests
