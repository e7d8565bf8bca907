#include <algorithm>
#include <cmath>
#include <numbers>

#include "formula.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

// --- q' ---

// A move of q: a sum of v', v and g, each with a factor.
struct Move {
  const char* words;
  double new_velocity, velocity, gravity;
};

std::vector<Move> moves(double dt) {
  return {{" + dt v'", dt, 0, 0},
          {" + dt v", 0, dt, 0},
          {" + dt (v + v') / 2", dt / 2, dt / 2, 0},
          {" + dt (v + dt M^-1 f_e)", 0, dt, dt * dt},
          {" + dt v + dt^2/2 M^-1 f_e", 0, dt, dt * dt / 2},
          {" + dt v' + dt^2/2 M^-1 f_e", dt, 0, dt * dt / 2},
          {" + v'", 1, 0, 0},
          {"", 0, 0, 0}};
}

struct Lift {
  const char* words;
  double along[3];
};

std::vector<Lift> lifts(double delta, double dt) {
  return {{"", {0, 0, 0}},
          {" + (0, delta, 0)", {0, delta, 0}},
          {" - (0, delta, 0)", {0, -delta, 0}},
          {" + (0, 2 delta, 0)", {0, 2 * delta, 0}},
          {" + (delta, 0, 0)", {delta, 0, 0}},
          {" + (0, 0, delta)", {0, 0, delta}},
          {" + (delta, delta, delta)", {delta, delta, delta}},
          {" + (delta, delta, 0)", {delta, delta, 0}},
          {" + dt (0, delta, 0)", {0, dt * delta, 0}}};
}

// Whether this is the part's q' - q. Its answer holds q' - q - dt v'.
bool moves_like(const Asked& a, const Move& move, const Lift& lift) {
  for (Index i = 0; i < 3; ++i) {
    const double v_new = a.got(3 + i);
    const double moved = move.new_velocity * v_new + move.velocity * a.c.v(i) +
                         move.gravity * a.c.params.g(i) + lift.along[i];
    if (!same(a.got(i) + a.c.params.dt * v_new, moved)) return false;
  }
  return true;
}

bool three_are_right(const std::vector<Asked>& all, Index first) {
  return is_right(all, first) && is_right(all, first + 1) && is_right(all, first + 2);
}

void add_move(Words& sentences, const std::vector<Asked>& all, const std::string& where) {
  if (all.size() < kEnough || three_are_right(all, 0)) return;
  Words words;
  const std::vector<Move> move = moves(1);
  const std::vector<Lift> lift = lifts(1, 1);
  for (std::size_t i = 0; i < move.size(); ++i) {
    for (std::size_t k = 0; k < lift.size(); ++k) {
      const bool fit = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
        const double dt = a.c.params.dt;
        return moves_like(a, moves(dt)[i], lifts(a.c.params.delta, dt)[k]);
      });
      if (fit) words.push_back(std::string("q") + move[i].words + lift[k].words);
    }
  }
  if (words.empty() || words.size() > 2) return;
  const std::string formula = words.size() == 2 ? "either " + joined(words, " or ") : words[0];
  add_formula(sentences, where + " your q'", formula);
}

bool is_whole(double turns) { return same(turns, std::round(turns)); }

// Whether theta' is wrong by whole turns, and x' and y' are right.
bool loses_turns(const std::vector<Asked>& all) {
  return is_right(all, 0) && is_right(all, 1) && !is_right(all, 2) &&
         std::all_of(all.begin(), all.end(), [](const Asked& a) {
           return is_whole((a.got(2) - a.right(2)) / (2 * std::numbers::pi));
         });
}

// --- v' ---

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
  if (all.size() < kEnough || three_are_right(all, 3)) return;
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

}  // namespace

Words formulas_of_part3(const std::vector<Asked>& all) {
  std::vector<Asked> touching, flying;
  for (const Asked& a : all) {
    if (a.c.corner.rfind("no corner", 0) == 0) flying.push_back(a);
    if (a.c.corner.rfind("corner", 0) == 0) touching.push_back(a);
  }
  Words sentences;
  add_velocity(sentences, touching, "Where a corner touches,", true);
  add_velocity(sentences, flying, "In flight,", false);
  if (loses_turns(all))
    sentences.push_back("Your theta' differs from the right one by whole turns.");
  add_move(sentences, touching, "Where a corner touches,");
  add_move(sentences, flying, "In flight,");
  return sentences;
}

}  // namespace bounce::tests
