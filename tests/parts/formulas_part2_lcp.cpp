#include "formula.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "recognise.hpp"

namespace bounce::tests::formula {
namespace {

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
      {"(1 + sqrt(epsilon)) ", [](C c) { return 1 + std::sqrt(c.params.epsilon); }},
      {"(1 + epsilon^2) ", [](C c) { return 1 + c.params.epsilon * c.params.epsilon; }},
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

}  // namespace

Words of_part2(const std::vector<Asked>& all) {
  Words sentences;
  add_block(sentences, all);
  add_border(sentences, all, "last column", range(12, 4));
  add_border(sentences, all, "last row", {3, 7, 11, 15});
  for (const int row : {0, 1, 2}) add_row_of_p(sentences, all, row);
  if (!is_right(all, 19)) add(sentences, "Your p(3)", in_factors(all, {19}));
  return sentences;
}

}  // namespace bounce::tests::formula
