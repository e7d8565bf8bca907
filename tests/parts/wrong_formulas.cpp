#include "wrong_formulas.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;
using Numbers = Eigen::VectorXd;

// A question, its right answer and the part's, in numbers.
struct Asked {
  const Case& c;
  const Numbers &right, &got;
};

struct Formula {
  std::string words;
  std::function<double(const Asked&)> value;
};

using Formulas = std::vector<Formula>;

// --- which formula fits ---

bool fits(const Formula& formula, const std::vector<Asked>& all,
          const std::function<double(const Asked&)>& number) {
  return all.size() >= kEnough && std::all_of(all.begin(), all.end(), [&](const Asked& asked) {
           return same(formula.value(asked), number(asked));
         });
}

// The words of the formulas that fit: "a", or "either a or b". Empty if none or more do.
std::string fitting(const Formulas& formulas, const std::vector<Asked>& all,
                    const std::function<double(const Asked&)>& number) {
  Words words;
  for (const Formula& formula : formulas) {
    if (fits(formula, all, number)) words.push_back(formula.words);
  }
  if (words.size() > 2) return "";
  return words.size() == 2 ? "either " + words[0] + " or " + words[1] : joined(words);
}

std::function<double(const Asked&)> entry(Index i) {
  return [i](const Asked& asked) { return asked.got(i); };
}

bool is_right(const std::vector<Asked>& all, Index i) {
  return std::all_of(all.begin(), all.end(),
                     [&](const Asked& asked) { return same(asked.got(i), asked.right(i)); });
}

void add(Words& sentences, const std::string& subject, const std::string& formula) {
  if (!formula.empty()) sentences.push_back(subject + " is " + formula + " in every question.");
}

// --- part 1 ---

double r_x(const Asked& a) { return a.right(5); }
double r_y(const Asked& a) { return -a.right(2); }
double x(const Asked& a) { return a.c.q(0); }
double y(const Asked& a) { return a.c.q(1); }
double l(const Asked& a) { return a.c.params.l; }

const Formulas& heights() {
  static const Formulas all{
      {"0", [](const Asked&) { return 0.0; }},
      {"y, the height of the centre", y},
      {"y - l/2", [](const Asked& a) { return y(a) - l(a) / 2; }},
      {"y - l", [](const Asked& a) { return y(a) - l(a); }},
      {"y - l/sqrt(2)", [](const Asked& a) { return y(a) - l(a) / std::sqrt(2); }},
      {"-phi", [](const Asked& a) { return -a.right(6); }},
      {"the absolute value of phi", [](const Asked& a) { return std::abs(a.right(6)); }},
      {"max(0, phi)", [](const Asked& a) { return std::max(0.0, a.right(6)); }},
      {"max(0, -phi)", [](const Asked& a) { return std::max(0.0, -a.right(6)); }},
      {"phi - delta", [](const Asked& a) { return a.right(6) - a.c.params.delta; }},
      {"r_y", r_y},
      {"-r_y", [](const Asked& a) { return -r_y(a); }},
      {"x + r_x, the x of the corner", [](const Asked& a) { return x(a) + r_x(a); }},
      {"x + r_y", [](const Asked& a) { return x(a) + r_y(a); }},
      {"y + r_x", [](const Asked& a) { return y(a) + r_x(a); }},
      {"y - r_y, the height of the highest corner", [](const Asked& a) { return y(a) - r_y(a); }},
      {"y + 2 r_y", [](const Asked& a) { return y(a) + 2 * r_y(a); }}};
  return all;
}

const Formulas& arms() {
  static const Formulas all{
      {"r_x", r_x},
      {"-r_x", [](const Asked& a) { return -r_x(a); }},
      {"r_y", r_y},
      {"-r_y", [](const Asked& a) { return -r_y(a); }},
      {"0", [](const Asked&) { return 0.0; }},
      {"the absolute value of r_x", [](const Asked& a) { return std::abs(r_x(a)); }},
      {"y, the height of the centre", y},
      {"-y", [](const Asked& a) { return -y(a); }},
      {"phi", [](const Asked& a) { return a.right(6); }},
      {"-phi", [](const Asked& a) { return -a.right(6); }},
      {"x + r_x", [](const Asked& a) { return x(a) + r_x(a); }}};
  return all;
}

Words of_part1(const std::vector<Asked>& all) {
  Words sentences;
  if (!is_right(all, 6)) add(sentences, "Your phi", fitting(heights(), all, entry(6)));
  const auto wrong_arm = [&](const std::string& name, Index i, const std::string& due) {
    const std::string formula = is_right(all, i) ? "" : fitting(arms(), all, entry(i));
    if (!formula.empty()) {
      sentences.push_back("The third entry of your " + name + " is " + formula +
                          " in every question, where " + due + " belongs.");
    }
  };
  if (is_right(all, 0)) wrong_arm("J_t", 2, "-r_y");
  if (is_right(all, 4)) wrong_arm("J_n", 5, "r_x");
  return sentences;
}

// --- part 2 ---

struct Factor {
  std::string words;
  std::function<double(const Case&)> value;
};

const std::vector<Factor>& border_factors() {
  static const std::vector<Factor> all{
      {"0", [](const Case&) { return 0.0; }},
      {"1", [](const Case&) { return 1.0; }},
      {"-1", [](const Case&) { return -1.0; }},
      {"mu", [](const Case& c) { return c.params.mu; }},
      {"-mu", [](const Case& c) { return -c.params.mu; }},
      {"2 mu", [](const Case& c) { return 2 * c.params.mu; }},
      {"dt", [](const Case& c) { return c.params.dt; }},
      {"mu dt", [](const Case& c) { return c.params.mu * c.params.dt; }},
      {"-dt", [](const Case& c) { return -c.params.dt; }},
      {"epsilon", [](const Case& c) { return c.params.epsilon; }}};
  return all;
}

// "(mu, 1, 1, 0)", if each of the entries is one factor in every question.
std::string in_factors(const std::vector<Asked>& all, const std::vector<Index>& entries) {
  Words words;
  for (const Index i : entries) {
    Formulas formulas;
    for (const Factor& f : border_factors()) {
      formulas.push_back({f.words, [f](const Asked& a) { return f.value(a.c); }});
    }
    words.push_back(fitting(formulas, all, entry(i)));
    if (words.back().empty() || words.back()[0] == 'e') return "";
  }
  return "(" + joined(words, ", ") + ")";
}

void add_border(Words& sentences, const std::vector<Asked>& all, const std::string& name,
                const std::vector<Index>& entries) {
  const bool right =
      std::all_of(entries.begin(), entries.end(), [&](Index i) { return is_right(all, i); });
  const std::string words = right ? "" : in_factors(all, entries);
  if (!words.empty()) add(sentences, "The " + name + " of your V", words);
}

const std::vector<Factor>& velocity_factors() {
  using C = const Case&;
  static const std::vector<Factor> all{
      {"0", [](C) { return 0.0; }},
      {"", [](C) { return 1.0; }},
      {"-", [](C) { return -1.0; }},
      {"epsilon ", [](C c) { return c.params.epsilon; }},
      {"-epsilon ", [](C c) { return -c.params.epsilon; }},
      {"(1 + epsilon) ", [](C c) { return 1 + c.params.epsilon; }},
      {"-(1 + epsilon) ", [](C c) { return -1 - c.params.epsilon; }},
      {"(1 - epsilon) ", [](C c) { return 1 - c.params.epsilon; }},
      {"mu ", [](C c) { return c.params.mu; }},
      {"(1 + mu) ", [](C c) { return 1 + c.params.mu; }},
      {"(1 - mu) ", [](C c) { return 1 - c.params.mu; }},
      {"m ", [](C c) { return c.params.m; }},
      {"2 ", [](C) { return 2.0; }}};
  return all;
}

// Of gravity's term: what dt M^-1 f_e is multiplied by.
const std::vector<Factor>& gravity_factors() {
  using C = const Case&;
  static const std::vector<Factor> all{
      {"0", [](C) { return 0.0; }},
      {"dt M^-1 f_e", [](C) { return 1.0; }},
      {"-dt M^-1 f_e", [](C) { return -1.0; }},
      {"2 dt M^-1 f_e", [](C) { return 2.0; }},
      {"M^-1 f_e", [](C c) { return 1 / c.params.dt; }},
      {"dt^2 M^-1 f_e", [](C c) { return c.params.dt; }},
      {"(1 + epsilon) dt M^-1 f_e", [](C c) { return 1 + c.params.epsilon; }},
      {"-(1 + epsilon) dt M^-1 f_e", [](C c) { return -1 - c.params.epsilon; }},
      {"epsilon dt M^-1 f_e", [](C c) { return c.params.epsilon; }},
      {"m dt M^-1 f_e", [](C c) { return c.params.m; }},
      {"dt M^-2 f_e", [](C c) { return 1 / c.params.m; }},
      {"m^2 dt M^-1 f_e", [](C c) { return c.params.m * c.params.m; }}};
  return all;
}

// What is added in the brackets of "J^T (a v + b)".
std::string sum(const std::string& velocity, const std::string& gravity) {
  const std::string v = velocity == "0" ? "" : velocity + "v";
  if (gravity == "0") return v.empty() ? "0" : v;
  if (v.empty()) return gravity;
  return gravity[0] == '-' ? v + " - " + gravity.substr(1) : v + " + " + gravity;
}

void add_row_of_p(Words& sentences, const std::vector<Asked>& all, int row) {
  const Index i = 16 + row, column = row == 0 ? 1 : 0;
  if (is_right(all, i)) return;
  Formulas formulas;
  for (const Factor& of_v : velocity_factors()) {
    for (const Factor& of_g : gravity_factors()) {
      if (of_v.words == "0" && of_g.words == "0") continue;  // said in other words
      formulas.push_back(
          {std::string(row == 0 ? "J_n" : "J_t") + "^T (" + sum(of_v.words, of_g.words) + ")",
           [=](const Asked& a) {
             const Vector3 J = a.c.J.col(column), &v = a.c.v, &g = a.c.params.g;
             return of_v.value(a.c) * J.dot(v) + of_g.value(a.c) * a.c.params.dt * J.dot(g);
           }});
    }
  }
  if (row == 0) {
    formulas.push_back(
        {"J_n^T (v + dt M^-1 f_e), with epsilon J_n^T v only where the corner comes down",
         [](const Asked& a) {
           const double v_n = a.c.J.col(1).dot(a.c.v);
           return v_n + std::min(0.0, a.c.params.epsilon * v_n) +
                  a.c.params.dt * a.c.J.col(1).dot(a.c.params.g);
         }});
  }
  add(sentences, "Your p(" + std::to_string(row) + ")", fitting(formulas, all, entry(i)));
}

// What may stand for M^-1 in the block: the diagonal, by the words that say so.
struct Diagonal {
  std::string words;
  std::function<Vector3(const Parameters&)> value;
};

std::vector<Diagonal> diagonals() {
  using P = const Parameters&;
  std::vector<Diagonal> all{{"M^-1", [](P p) { return Vector3(p.M().diagonal().cwiseInverse()); }},
                            {"M", [](P p) { return Vector3(p.M().diagonal()); }},
                            {"the identity", [](P) { return Vector3(1, 1, 1); }}};
  const auto inertia = [&](const std::string& words, std::function<double(P)> value) {
    all.push_back({"M^-1 with " + words + " for the inertia",
                   [value](P p) { return Vector3(1 / p.m, 1 / p.m, 1 / value(p)); }});
  };
  all.push_back({"M^-1 without its last entry", [](P p) { return Vector3(1 / p.m, 1 / p.m, 0); }});
  inertia("m l^2 / 24", [](P p) { return p.m * p.l * p.l / 24; });
  inertia("2 m l^2 / 3", [](P p) { return p.m * p.l * p.l * 2 / 3; });
  inertia("m l^2 / 12", [](P p) { return p.m * p.l * p.l / 12; });
  inertia("m l^2 / 8", [](P p) { return p.m * p.l * p.l / 8; });
  inertia("m l^2 / 4", [](P p) { return p.m * p.l * p.l / 4; });
  inertia("m l^2 / 3", [](P p) { return p.m * p.l * p.l / 3; });
  inertia("m l^2 / 2", [](P p) { return p.m * p.l * p.l / 2; });
  inertia("2 m l^2 / 5", [](P p) { return p.m * p.l * p.l * 2 / 5; });
  inertia("m l^2", [](P p) { return p.m * p.l * p.l; });
  inertia("m l / 6", [](P p) { return p.m * p.l / 6; });
  inertia("m l / sqrt(6)", [](P p) { return p.m * p.l / std::sqrt(6); });
  inertia("l^2 / 6", [](P p) { return p.l * p.l / 6; });
  inertia("m", [](P p) { return p.m; });
  inertia("6 / (m l^2)", [](P p) { return 6 / (p.m * p.l * p.l); });
  return all;
}

std::vector<Factor> steps() {
  using C = const Case&;
  return {{"dt", [](C c) { return c.params.dt; }},
          {"1", [](C) { return 1.0; }},
          {"dt^2", [](C c) { return c.params.dt * c.params.dt; }},
          {"dt / 2", [](C c) { return c.params.dt / 2; }},
          {"1/dt", [](C c) { return 1 / c.params.dt; }}};
}

Eigen::Matrix3d block(const Case& c, const Vector3& diagonal, double step) {
  Eigen::Matrix3d directions;
  directions << c.J.col(1), -c.J.col(0), c.J.col(0);
  return directions.transpose() * diagonal.asDiagonal() * directions * step;
}

// The factor 1, -1 or 0 by which each entry differs, if it is the same in every question.
std::optional<Eigen::Matrix3d> signs(const std::vector<Asked>& all, const Diagonal& diagonal,
                                     const Factor& step) {
  Eigen::Matrix3d found = Eigen::Matrix3d::Constant(2);
  for (const Asked& a : all) {
    const auto expected = block(a.c, diagonal.value(a.c.params), step.value(a.c));
    for (const Index j : {0, 1, 2}) {
      for (const Index i : {0, 1, 2}) {
        const double e = expected(i, j), g = a.got(i + 4 * j);
        if (same(e, g) && same(e, -g)) continue;
        const double sign = same(e, g) ? 1 : same(e, -g) ? -1 : g == 0 ? 0 : 2;
        if (sign == 2 || (found(i, j) != 2 && found(i, j) != sign)) return std::nullopt;
        found(i, j) = sign;
      }
    }
  }
  return (found.array() == 2).any() || found.diagonal().isZero(0) ? std::nullopt
                                                                  : std::optional(found);
}

std::string entries_with(double sign, const Eigen::Matrix3d& signs) {
  Words names;
  for (const Index i : {0, 1, 2}) {
    for (const Index j : {0, 1, 2}) {
      if (signs(i, j) == sign) {
        names.push_back("V(" + std::to_string(i) + ", " + std::to_string(j) + ")");
      }
    }
  }
  return joined(names);
}

void add_block(Words& sentences, const std::vector<Asked>& all) {
  bool right = true;
  for (const Index i : {0, 1, 2, 4, 5, 6, 8, 9, 10}) right = right && is_right(all, i);
  if (right) return;
  std::vector<std::pair<std::string, Eigen::Matrix3d>> found;
  for (const Diagonal& diagonal : diagonals()) {
    for (const Factor& step : steps()) {
      const auto fit = signs(all, diagonal, step);
      if (fit)
        found.push_back({"J_hat^T M^-1 J_hat dt with " + diagonal.words + " for M^-1 and " +
                             step.words + " for dt",
                         *fit});
      if (fit && diagonal.words == "M^-1")
        found.back().first = "J_hat^T M^-1 J_hat dt with " + step.words + " for dt";
      if (fit && step.words == "dt")
        found.back().first = diagonal.words == "M^-1"
                                 ? ""
                                 : "J_hat^T M^-1 J_hat dt with " + diagonal.words + " for M^-1";
    }
  }
  if (found.size() != 1) return;
  const auto& [words, sign] = found.front();
  const std::string but = words.empty() ? "" : "in absolute values ";
  const std::string negative = entries_with(-1, sign), zero = entries_with(0, sign);
  if (!words.empty())
    add(sentences, "The 3x3 block of your V", (sign == Eigen::Matrix3d::Ones() ? "" : but) + words);
  if (sign == -Eigen::Matrix3d::Ones()) {
    sentences.push_back("The whole 3x3 block of your V has the other sign.");
  } else if (!negative.empty()) {
    sentences.push_back("The other sign in every question: " + negative + ".");
  }
  if (!zero.empty()) sentences.push_back("Zero in every question: " + zero + ".");
}

Words of_part2(const std::vector<Asked>& all) {
  Words sentences;
  add_block(sentences, all);
  add_border(sentences, all, "last column", range(12, 4));
  add_border(sentences, all, "last row", {3, 7, 11, 15});
  for (const int row : {0, 1, 2}) add_row_of_p(sentences, all, row);
  if (!is_right(all, 19)) add(sentences, "Your p(3)", in_factors(all, {19}));
  return sentences;
}

// --- part 3 ---

// A move of q, and what is added to it.
struct Move {
  std::string words;
  std::function<Vector3(const Asked&)> value;
};

Vector3 new_velocity(const Asked& a) { return a.got.tail<3>(); }

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
           [](const Asked& a) { return Vector3(0, a.c.params.dt * a.c.params.delta, 0); }}};
}

bool same_vector(const Vector3& a, const Vector3& b) {
  return same(a(0), b(0)) && same(a(1), b(1)) && same(a(2), b(2));
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

bool is_whole(double turns) { return same(turns, std::round(turns)); }

// Whether theta' is wrong by whole turns, and x' and y' are right.
bool loses_turns(const std::vector<Asked>& all) {
  return is_right(all, 0) && is_right(all, 1) && !is_right(all, 2) &&
         std::all_of(all.begin(), all.end(), [](const Asked& a) {
           return is_whole((a.got(2) - a.right(2)) / (2 * std::numbers::pi));
         });
}

Words of_part3(const std::vector<Asked>& all) {
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

}  // namespace

Words formulas(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
               const std::vector<Answer>& got) {
  std::vector<Asked> all;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (!got[k].thrown.empty() || got[k].numbers.size() != right[k].numbers.size() ||
        !got[k].numbers.allFinite()) {
      return {};
    }
    all.push_back({cases[k], right[k].numbers, got[k].numbers});
  }
  return part == 1   ? of_part1(all)
         : part == 2 ? of_part2(all)
         : part == 3 ? of_part3(all)
                     : Words();
}

}  // namespace bounce::tests
