#include "formula.hpp"

#include <algorithm>
#include <cmath>

#include "recognise.hpp"

namespace bounce::tests::formula {
namespace {

// Gravity's part of v', by what it is a multiple of dt g.
std::vector<Factor> gravity_in_v() {
  using C = const Case&;
  return {{"", [](C) { return 1.0; }},
          {"without gravity", [](C) { return 0.0; }},
          {"with twice gravity", [](C) { return 2.0; }},
          {"with gravity upwards", [](C) { return -1.0; }},
          {"with gravity not multiplied by dt", [](C c) { return 1 / c.params.dt; }},
          {"with gravity multiplied by dt^2", [](C c) { return c.params.dt; }},
          {"with half of gravity", [](C) { return 0.5; }},
          {"with m g in place of g", [](C c) { return c.params.m; }},
          {"with g / m in place of g", [](C c) { return 1 / c.params.m; }}};
}

std::vector<Factor> force_factors() {
  using C = const Case&;
  const auto inertia = [](C c) { return c.params.M()(2, 2); };
  return {{"1", [](C) { return 1.0; }},
          {"0", [](C) { return 0.0; }},
          {"-1", [](C) { return -1.0; }},
          {"2", [](C) { return 2.0; }},
          {"1/2", [](C) { return 0.5; }},
          {"1/dt", [](C c) { return 1 / c.params.dt; }},
          {"dt", [](C c) { return c.params.dt; }},
          {"m", [](C c) { return c.params.m; }},
          {"m^2", [](C c) { return c.params.m * c.params.m; }},
          {"m r_g^2", inertia},
          {"(m r_g^2)^2", [=](C c) { return inertia(c) * inertia(c); }},
          {"r_g^2", [=](C c) { return inertia(c) / c.params.m; }},
          {"mu", [](C c) { return c.params.mu; }},
          {"epsilon", [](C c) { return c.params.epsilon; }}};
}

Vector3 without_gravity(const Asked& a, const Numbers& numbers, double gravity) {
  return numbers.tail<3>() - a.c.v - gravity * a.c.params.dt * a.c.params.g;
}

// Parameters by which a number stands that is written down.
const std::vector<Factor>& written_factors() {
  using C = const Case&;
  static const std::vector<Factor> all{
      {"l^2 / ", [](C c) { return c.params.l * c.params.l; }},
      {"m / ", [](C c) { return c.params.m; }},
      {"m l^2 / ", [](C c) { return c.params.m * c.params.l * c.params.l; }}};
  return all;
}

// "l^2 / 0.16", if the component's change is the right one times this. Empty if none fits.
std::string by_a_written_number(const std::vector<Asked>& all, const Factor& gravity, Index i) {
  for (const Factor& f : written_factors()) {
    const auto due = [&](const Asked& a) {
      return f.value(a.c) * without_gravity(a, a.right, 1)(i);
    };
    const auto largest = std::max_element(all.begin(), all.end(), [&](auto& a, auto& b) {
      return std::abs(due(a)) < std::abs(due(b));
    });
    const double number =
        due(*largest) / without_gravity(*largest, largest->got, gravity.value(largest->c))(i);
    const bool fit =
        std::isfinite(number) && std::all_of(all.begin(), all.end(), [&](auto& a) {
          return same(due(a) / number, without_gravity(a, a.got, gravity.value(a.c))(i));
        });
    if (fit) return f.words + digits(number);
  }
  return "";
}

// By what the forces' change of each component of v is multiplied: "(1, 1, 0)". Empty if by nothing
// that is known.
std::string force_words(const std::vector<Asked>& all, const Factor& gravity) {
  Words words;
  for (const Index i : {0, 1, 2}) {
    Formulas formulas;
    for (const Factor& f : force_factors()) {
      formulas.push_back({f.words, [=](const Asked& a) {
                            return f.value(a.c) * without_gravity(a, a.right, 1)(i);
                          }});
    }
    words.push_back(fitting(formulas, all, [=](const Asked& a) {
      return without_gravity(a, a.got, gravity.value(a.c))(i);
    }));
    if (words.back().empty()) words.back() = by_a_written_number(all, gravity, i);
    if (words.back().empty() || words.back()[0] == 'e') return "";
  }
  return "(" + joined(words, ", ") + ")";
}

void add_velocity(Words& sentences, const std::vector<Asked>& all, const std::string& where,
                  bool touches) {
  if (all.size() < kEnough || (is_right(all, 3) && is_right(all, 4) && is_right(all, 5))) return;
  Words found;
  for (const Factor& gravity : gravity_in_v()) {
    if (!touches) {
      const bool fit = std::all_of(all.begin(), all.end(), [&](const Asked& a) {
        return without_gravity(a, a.got, gravity.value(a.c)).isZero(1e-9);
      });
      if (fit) found.push_back(where + " your v' is that " + gravity.words + ".");
      continue;
    }
    const std::string forces = force_words(all, gravity);
    if (forces.empty()) continue;
    std::string words = where + " your v' is that ";
    words += gravity.words;
    if (forces != "(1, 1, 1)") {
      words += std::string(gravity.words.empty() ? "" : ", and ") +
               "with the forces' change of (v_x, v_y, omega) multiplied by " + forces;
    }
    found.push_back(words + ".");
  }
  if (found.size() == 1) sentences.push_back(found[0]);
}

// --- the forces and their moment ---

// Where f_n or f_t is multiplied by something, and the moment follows them.
void add_forces(Words& sentences, const std::vector<Asked>& touching) {
  Words found;
  for (const Factor& normal : force_factors()) {
    for (const Factor& tangential : force_factors()) {
      const bool fit = std::all_of(touching.begin(), touching.end(), [&](const Asked& a) {
        const Vector3 r = lowest_corner(theta(a), l(a)), M = a.c.params.M().diagonal();
        const Vector3 due = without_gravity(a, a.right, 1), got = without_gravity(a, a.got, 1);
        const double f_n = normal.value(a.c) * M(1) * due(1);
        const double f_t = tangential.value(a.c) * M(0) * due(0);
        return same_vector(got, {f_t / M(0), f_n / M(1), (r(0) * f_n - r(1) * f_t) / M(2)});
      });
      if (!fit) continue;
      found.push_back("Where a corner touches, your v' is that with f_n multiplied by " +
                      normal.words + " and f_t by " + tangential.words + ".");
    }
  }
  if (touching.size() >= kEnough && found.size() == 1) sentences.push_back(found[0]);
}

// What the normal force, or friction, is multiplied by in the moment.
struct Arm {
  std::string words;
  std::function<double(double r_x, double r_y)> value;
};

const std::vector<Arm>& moment_arms() {
  static const std::vector<Arm> all{{"0", [](double, double) { return 0.0; }},
                                    {"r_x", [](double r_x, double) { return r_x; }},
                                    {"-r_x", [](double r_x, double) { return -r_x; }},
                                    {"r_y", [](double, double r_y) { return r_y; }},
                                    {"-r_y", [](double, double r_y) { return -r_y; }}};
  return all;
}

// Where v_x' and v_y' tell the forces and omega' doesn't fit them: the moment that omega' fits.
void add_moment(Words& sentences, const std::vector<Asked>& touching) {
  if (!is_right(touching, 3) || !is_right(touching, 4) || is_right(touching, 5)) return;
  Formulas formulas;
  for (const Arm& normal : moment_arms()) {
    for (const Arm& tangential : moment_arms()) {
      formulas.push_back(
          {"(" + normal.words + ") f_n + (" + tangential.words + ") f_t", [=](const Asked& a) {
             const Vector3 r = lowest_corner(theta(a), l(a));
             const Vector3 impulse = a.c.params.M() * without_gravity(a, a.right, 1);
             return normal.value(r(0), r(1)) * impulse(1) +
                    tangential.value(r(0), r(1)) * impulse(0);
           }});
    }
  }
  const std::string formula = fitting(formulas, touching, [](const Asked& a) {
    return a.c.params.M()(2, 2) * without_gravity(a, a.got, 1)(2);
  });
  add(sentences, "Where a corner touches, the moment of your forces, by omega',", formula);
}

}  // namespace

Words of_new_velocity(const std::vector<Asked>& touching, const std::vector<Asked>& flying) {
  Words sentences;
  add_velocity(sentences, touching, "Where a corner touches,", true);
  const bool is_wrong = !is_right(touching, 3) || !is_right(touching, 4) || !is_right(touching, 5);
  if (sentences.empty() && is_wrong) add_forces(sentences, touching);
  if (sentences.empty()) add_moment(sentences, touching);
  add_velocity(sentences, flying, "In flight,", false);
  return sentences;
}

}  // namespace bounce::tests::formula
