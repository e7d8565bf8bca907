#include <algorithm>
#include <cmath>
#include <numbers>

#include "formula.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

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

// phi, from q.
double height(const Asked& a) { return a.c.q(1) + lowest_corner(a.c.q(2), a.c.params.l).y; }

std::vector<Lift> lifts(double delta, double dt, double phi) {
  return {{"", {0, 0, 0}},
          {" + (0, delta, 0)", {0, delta, 0}},
          {" - (0, delta, 0)", {0, -delta, 0}},
          {" + (0, 2 delta, 0)", {0, 2 * delta, 0}},
          {" + (delta, 0, 0)", {delta, 0, 0}},
          {" + (0, 0, delta)", {0, 0, delta}},
          {" + (delta, delta, delta)", {delta, delta, delta}},
          {" + (delta, delta, 0)", {delta, delta, 0}},
          {" + dt (0, delta, 0)", {0, dt * delta, 0}},
          {" + (0, -phi, 0)", {0, -phi, 0}},
          {" + (0, delta - phi, 0)", {0, delta - phi, 0}},
          {" + (0, delta + max(0, -phi), 0)", {0, delta + std::max(0.0, -phi), 0}}};
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

bool moves_rightly(const std::vector<Asked>& all) {
  return is_right(all, 0) && is_right(all, 1) && is_right(all, 2);
}

void add_move(Words& sentences, const std::vector<Asked>& all, const std::string& where) {
  if (all.size() < kEnough || moves_rightly(all)) return;
  Words words;
  const std::vector<Move> move = moves(1);
  const std::vector<Lift> lift = lifts(1, 1, 1);
  for (std::size_t i = 0; i < move.size(); ++i) {
    for (std::size_t k = 0; k < lift.size(); ++k) {
      const bool fit = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
        const double dt = a.c.params.dt;
        return moves_like(a, moves(dt)[i], lifts(a.c.params.delta, dt, height(a))[k]);
      });
      if (fit) words.push_back(std::string("q") + move[i].words + lift[k].words);
    }
  }
  if (words.empty() || words.size() > 2) return;
  const std::string formula = words.size() == 2 ? "either " + joined(words, " or ") : words[0];
  add_formula(sentences, where + " your q'", formula);
}

void add_unmoved(Words& sentences, const std::vector<Asked>& all) {
  const char* const names[] = {"x", "y", "theta"};
  for (Index i = 0; i < 3; ++i) {
    const bool unmoved = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
      return same(a.got(i), -a.c.params.dt * a.got(3 + i));
    });
    const std::string name = names[i];
    if (unmoved) add_formula(sentences, "Your " + name + "'", name);
  }
}

// A number of q' that is right between two bounds. Tells more than its move.
void add_bounds_of_q(Words& sentences, const std::vector<Asked>& all) {
  const char* const names[] = {"x'", "y'", "theta'"};
  for (Index i = 0; i < 3; ++i) {
    std::vector<double> right, got;
    for (const Asked& a : all) {
      const auto next = [&](const Eigen::VectorXd& x) {
        return x(i) + a.c.q(i) + a.c.params.dt * x(3 + i);
      };
      right.push_back(next(a.right));
      got.push_back(next(a.got));
    }
    if (is_right(all, 3 + i)) add_bounds(sentences, names[i], right, got);
  }
}

void add_bounds_of_v(Words& sentences, const std::vector<Asked>& all) {
  const char* const names[] = {"v_x'", "v_y'", "omega'"};
  for (Index i = 0; i < 3; ++i)
    add_bounds(sentences, names[i], right_entry(all, 3 + i), entry(all, 3 + i));
}

bool is_whole(double turns) { return same(turns, std::round(turns)); }

// Whether theta' is wrong by whole turns, and x' and y' are right.
bool loses_turns(const std::vector<Asked>& all) {
  return is_right(all, 0) && is_right(all, 1) && !is_right(all, 2) &&
         std::all_of(all.begin(), all.end(), [](const Asked& a) {
           return is_whole((a.got(2) - a.right(2)) / (2 * std::numbers::pi));
         });
}

}  // namespace

Words formulas_of_part3(const std::vector<Asked>& all) {
  std::vector<Asked> touching, flying;
  for (const Asked& a : all) {
    if (a.c.corner.rfind("no corner", 0) == 0) flying.push_back(a);
    if (a.c.corner.rfind("corner", 0) == 0) touching.push_back(a);
  }
  Words sentences = formulas_of_new_velocity(touching, flying);
  if (sentences.empty()) add_bounds_of_v(sentences, all);
  add_bounds_of_q(sentences, all);
  if (loses_turns(all))
    sentences.push_back("Your theta' differs from the right one by whole turns.");
  if (!moves_rightly(all)) add_unmoved(sentences, all);
  add_move(sentences, touching, "Where a corner touches,");
  add_move(sentences, flying, "In flight,");
  return sentences;
}

}  // namespace bounce::tests
