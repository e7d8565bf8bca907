#include "formula.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recognise.hpp"

namespace bounce::tests::formula {
namespace {

Vector3 new_velocity(const Asked& a) { return a.got.tail<3>(); }

// A move of q, and what is added to it.
struct Move {
  std::string words;
  std::function<Vector3(const Asked&)> value;
};

std::vector<Move> moves() {
  return {{"dt v'", [](const Asked& a) { return Vector3(a.c.params.dt * new_velocity(a)); }},
          {"dt v", [](const Asked& a) { return Vector3(a.c.params.dt * a.c.v); }},
          {"dt (v + v') / 2",
           [](const Asked& a) { return Vector3(a.c.params.dt / 2 * (a.c.v + new_velocity(a))); }},
          {"dt (v + dt M^-1 f_e)",
           [](const Asked& a) {
             return Vector3(a.c.params.dt * (a.c.v + a.c.params.dt * a.c.params.g));
           }},
          {"dt v + dt^2/2 M^-1 f_e",
           [](const Asked& a) {
             const double dt = a.c.params.dt;
             return Vector3(dt * a.c.v + dt * dt / 2 * a.c.params.g);
           }},
          {"dt v' + dt^2/2 M^-1 f_e",
           [](const Asked& a) {
             const double dt = a.c.params.dt;
             return Vector3(dt * new_velocity(a) + dt * dt / 2 * a.c.params.g);
           }},
          {"v'", new_velocity},
          {"", [](const Asked&) { return Vector3(0, 0, 0); }}};
}

// phi, from q.
double height(const Asked& a) { return y(a) + lowest_corner(theta(a), l(a))(1); }

std::vector<Move> lifts() {
  const auto along = [](Vector3 direction) {
    return [direction](const Asked& a) { return Vector3(a.c.params.delta * direction); };
  };
  return {{"", along({0, 0, 0})},
          {" + (0, delta, 0)", along({0, 1, 0})},
          {" - (0, delta, 0)", along({0, -1, 0})},
          {" + (0, 2 delta, 0)", along({0, 2, 0})},
          {" + (delta, 0, 0)", along({1, 0, 0})},
          {" + (0, 0, delta)", along({0, 0, 1})},
          {" + (delta, delta, delta)", along({1, 1, 1})},
          {" + (delta, delta, 0)", along({1, 1, 0})},
          {" + dt (0, delta, 0)",
           [](const Asked& a) { return Vector3(0, a.c.params.dt * a.c.params.delta, 0); }},
          {" + (0, -phi, 0)", [](const Asked& a) { return Vector3(0, -height(a), 0); }},
          {" + (0, delta - phi, 0)",
           [](const Asked& a) { return Vector3(0, a.c.params.delta - height(a), 0); }},
          {" + (0, delta + max(0, -phi), 0)", [](const Asked& a) {
             return Vector3(0, a.c.params.delta + std::max(0.0, -height(a)), 0);
           }}};
}

bool moves_rightly(const std::vector<Asked>& all) {
  return is_right(all, 0) && is_right(all, 1) && is_right(all, 2);
}

void add_move(Words& sentences, const std::vector<Asked>& all, const std::string& where) {
  if (all.size() < kEnough || moves_rightly(all)) return;
  Words words;
  for (const Move& move : moves()) {
    for (const Move& lift : lifts()) {
      const bool fit = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
        const Vector3 moved = a.got.head<3>() + a.c.params.dt * new_velocity(a);
        return same_vector(moved, move.value(a) + lift.value(a));
      });
      if (fit) words.push_back("q" + (move.words.empty() ? "" : " + " + move.words) + lift.words);
    }
  }
  if (words.empty() || words.size() > 2) return;
  const std::string formula = words.size() == 2 ? "either " + joined(words, " or ") : words[0];
  sentences.push_back(where + " your q' is " + formula + " in every question.");
}

void add_unmoved(Words& sentences, const std::vector<Asked>& all) {
  const char* const names[] = {"x", "y", "theta"};
  for (const Index i : {0, 1, 2}) {
    const bool unmoved = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
      return same(a.got(i), -a.c.params.dt * new_velocity(a)(i));
    });
    const std::string name = names[i];
    if (unmoved) sentences.push_back("Your " + name + "' is " + name + " in every question.");
  }
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

Words of_part3(const std::vector<Asked>& all) {
  std::vector<Asked> touching, flying;
  for (const Asked& a : all) {
    if (a.c.corner.rfind("no corner", 0) == 0) flying.push_back(a);
    if (a.c.corner.rfind("corner", 0) == 0) touching.push_back(a);
  }
  Words sentences = of_new_velocity(touching, flying);
  if (loses_turns(all))
    sentences.push_back("Your theta' differs from the right one by whole turns.");
  if (!moves_rightly(all)) add_unmoved(sentences, all);
  add_move(sentences, touching, "Where a corner touches,");
  add_move(sentences, flying, "In flight,");
  return sentences;
}

}  // namespace bounce::tests::formula
