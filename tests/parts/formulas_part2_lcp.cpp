#include <algorithm>
#include <cmath>
#include <optional>

#include "formula.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

// --- the border of V, and p(3) ---

std::vector<Value> border_factors(const Asked& a) {
  const double mu = a.c.params.mu, dt = a.c.params.dt;
  return {{"0", 0},     {"1", 1},
          {"-1", -1},   {"mu", mu},
          {"-mu", -mu}, {"2 mu", 2 * mu},
          {"dt", dt},   {"mu dt", mu * dt},
          {"-dt", -dt}, {"epsilon", a.c.params.epsilon}};
}

// "(mu, 1, 1, 0)", if each of the entries is one factor in every question.
std::string in_factors(const std::vector<Asked>& all, const std::vector<Index>& entries) {
  const std::vector<Formula> factors = in_all(all, border_factors);
  Words words;
  for (const Index i : entries) {
    words.push_back(fitting(factors, entry(all, i)));
    if (words.back().empty() || words.back()[0] == 'e') return "";
  }
  return "(" + joined(words, ", ") + ")";
}

bool are_right(const std::vector<Asked>& all, const std::vector<Index>& entries) {
  return std::all_of(entries.begin(), entries.end(), [&](Index i) { return is_right(all, i); });
}

void add_border(Words& sentences, const std::vector<Asked>& all, const std::string& subject,
                const std::vector<Index>& entries) {
  if (!are_right(all, entries)) add_formula(sentences, subject, in_factors(all, entries));
}

// --- the other rows of p ---

// What v is multiplied by.
std::vector<Value> velocity_factors(const Asked& a) {
  const double mu = a.c.params.mu, epsilon = a.c.params.epsilon;
  return {{"0", 0},
          {"", 1},
          {"-", -1},
          {"epsilon ", epsilon},
          {"-epsilon ", -epsilon},
          {"(1 + epsilon) ", 1 + epsilon},
          {"-(1 + epsilon) ", -1 - epsilon},
          {"(1 - epsilon) ", 1 - epsilon},
          {"(1 + sqrt(epsilon)) ", 1 + std::sqrt(epsilon)},
          {"(1 + epsilon^2) ", 1 + epsilon * epsilon},
          {"mu ", mu},
          {"(1 + mu) ", 1 + mu},
          {"(1 - mu) ", 1 - mu},
          {"m ", a.c.params.m},
          {"2 ", 2}};
}

// What dt M^-1 f_e is multiplied by.
std::vector<Value> gravity_factors(const Asked& a) {
  const double m = a.c.params.m, dt = a.c.params.dt, epsilon = a.c.params.epsilon;
  return {{"0", 0},
          {"dt M^-1 f_e", 1},
          {"-dt M^-1 f_e", -1},
          {"2 dt M^-1 f_e", 2},
          {"M^-1 f_e", 1 / dt},
          {"dt^2 M^-1 f_e", dt},
          {"(1 + epsilon) dt M^-1 f_e", 1 + epsilon},
          {"-(1 + epsilon) dt M^-1 f_e", -1 - epsilon},
          {"epsilon dt M^-1 f_e", epsilon},
          {"m dt M^-1 f_e", m},
          {"dt M^-2 f_e", 1 / m},
          {"m^2 dt M^-1 f_e", m * m}};
}

// The components of v and of dt M^-1 f_e along a column of J.
double along_v(const Asked& a, Index column) { return a.c.J.col(column).dot(a.c.v); }
double along_g(const Asked& a, Index column) {
  return a.c.params.dt * a.c.J.col(column).dot(a.c.params.g);
}

std::vector<Formula> rows_of_p(const std::vector<Asked>& all, Index column) {
  std::vector<Formula> rows;
  for (const Formula& of_v : in_all(all, velocity_factors)) {
    for (const Formula& of_g : in_all(all, gravity_factors)) {
      if (of_v.words == "0" && of_g.words == "0") continue;  // said in other words
      const std::string terms = sum(product(of_v.words, "v"), of_g.words);
      Formula row{(column == 1 ? "J_n^T (" : "J_t^T (") + terms + ")", {}};
      for (std::size_t k = 0; k < all.size(); ++k) {
        row.values.push_back(of_v.values[k] * along_v(all[k], column) +
                             of_g.values[k] * along_g(all[k], column));
      }
      rows.push_back(row);
    }
  }
  return rows;
}

Formula restitution_of_approach(const std::vector<Asked>& all) {
  Formula row{"J_n^T (v + dt M^-1 f_e), with epsilon J_n^T v only where the corner comes down", {}};
  for (const Asked& a : all) {
    const double v_n = along_v(a, 1);
    row.values.push_back(v_n + std::min(0.0, a.c.params.epsilon * v_n) + along_g(a, 1));
  }
  return row;
}

void add_row_of_p(Words& sentences, const std::vector<Asked>& all, int row) {
  const Index i = 16 + row;
  if (is_right(all, i)) return;
  std::vector<Formula> rows = rows_of_p(all, row == 0 ? 1 : 0);
  if (row == 0) rows.push_back(restitution_of_approach(all));
  const std::string name = "p(" + std::to_string(row) + ")";
  const std::string formula = fitting(rows, entry(all, i));
  add_formula(sentences, "Your " + name, formula);
  if (formula.empty()) add_bounds(sentences, name, right_entry(all, i), entry(all, i));
}

// --- the block of V ---

// What may stand for M^-1, in words that follow "with": its first two entries, and its last one.
struct Diagonal {
  const char* words;
  double first, last;
};

std::vector<Diagonal> diagonals(const Parameters& p) {
  const double m = p.m, l = p.l, inertia = m * l * l / 6;
  return {{"M^-1", 1 / m, 1 / inertia},
          {"M for M^-1", m, inertia},
          {"the identity for M^-1", 1, 1},
          {"0 for the last entry of M^-1", 1 / m, 0},
          {"m l^2 / 24 for the inertia", 1 / m, 1 / (m * l * l / 24)},
          {"2 m l^2 / 3 for the inertia", 1 / m, 1 / (m * l * l * 2 / 3)},
          {"m l^2 / 12 for the inertia", 1 / m, 1 / (m * l * l / 12)},
          {"m l^2 / 8 for the inertia", 1 / m, 1 / (m * l * l / 8)},
          {"m l^2 / 4 for the inertia", 1 / m, 1 / (m * l * l / 4)},
          {"m l^2 / 3 for the inertia", 1 / m, 1 / (m * l * l / 3)},
          {"m l^2 / 2 for the inertia", 1 / m, 1 / (m * l * l / 2)},
          {"2 m l^2 / 5 for the inertia", 1 / m, 1 / (m * l * l * 2 / 5)},
          {"m l^2 for the inertia", 1 / m, 1 / (m * l * l)},
          {"m l / 6 for the inertia", 1 / m, 1 / (m * l / 6)},
          {"m l / sqrt(6) for the inertia", 1 / m, 1 / (m * l / std::sqrt(6))},
          {"l^2 / 6 for the inertia", 1 / m, 1 / (l * l / 6)},
          {"m for the inertia", 1 / m, 1 / m},
          {"6 / (m l^2) for the inertia", 1 / m, 1 / (6 / (m * l * l))}};
}

std::vector<Value> steps(const Parameters& p) {
  return {{"dt", p.dt}, {"1", 1}, {"dt^2", p.dt * p.dt}, {"dt / 2", p.dt / 2}, {"1/dt", 1 / p.dt}};
}

// An entry of J_hat^T D J_hat times the step, for J_hat = [J_n -J_t J_t].
double block_entry(const Jacobian& J, Index i, Index j, const Diagonal& d, double step) {
  const Index column[] = {1, 0, 0};
  const double sign[] = {1, -1, 1};
  const auto product = [&](Index k) { return J(k, column[i]) * J(k, column[j]); };
  return sign[i] * sign[j] * (d.first * (product(0) + product(1)) + d.last * product(2)) * step;
}

constexpr double kUnknown = 2;

// By which factor 1, -1 or 0 each entry of the block differs from one that is made like this.
using Signs = Eigen::Matrix3d;

bool are_all(const Signs& signs, double sign) {
  return std::all_of(signs.data(), signs.data() + 9, [&](double s) { return s == sign; });
}

// The factors, if they are the same in every question.
std::optional<Signs> signs_of(const std::vector<Asked>& all, std::size_t diagonal,
                              std::size_t step) {
  Signs found = Signs::Constant(kUnknown);
  for (const Asked& a : all) {
    const Diagonal d = diagonals(a.c.params)[diagonal];
    const double dt = steps(a.c.params)[step].value;
    for (Index j = 0; j < 3; ++j) {
      for (Index i = 0; i < 3; ++i) {
        const double e = block_entry(a.c.J, i, j, d, dt), g = a.got(i + 4 * j);
        if (same(e, g) && same(e, -g)) continue;
        const double sign = same(e, g) ? 1 : same(e, -g) ? -1 : g == 0 ? 0 : kUnknown;
        if (sign == kUnknown || (found(i, j) != kUnknown && found(i, j) != sign)) {
          return std::nullopt;
        }
        found(i, j) = sign;
      }
    }
  }
  const bool is_known = std::find(found.data(), found.data() + 9, kUnknown) == found.data() + 9;
  const bool has_diagonal = found(0, 0) != 0 || found(1, 1) != 0 || found(2, 2) != 0;
  return is_known && has_diagonal ? std::optional(found) : std::nullopt;
}

std::string entries_with(double sign, const Signs& signs) {
  Words names;
  for (Index i = 0; i < 3; ++i) {
    for (Index j = 0; j < 3; ++j) {
      if (signs(i, j) == sign) {
        names.push_back("V(" + std::to_string(i) + ", " + std::to_string(j) + ")");
      }
    }
  }
  return joined(names);
}

// "J_hat^T M^-1 J_hat dt with M for M^-1"; empty for the right diagonal and step.
std::string block_words(const std::string& diagonal, const std::string& step) {
  Words with;
  if (diagonal != "M^-1") with.push_back(diagonal);
  if (step != "dt") with.push_back(step + " for dt");
  return with.empty() ? "" : "J_hat^T M^-1 J_hat dt with " + joined(with);
}

void add_block(Words& sentences, const std::vector<Asked>& all) {
  if (are_right(all, {0, 1, 2, 4, 5, 6, 8, 9, 10})) return;
  std::vector<std::pair<std::string, Signs>> found;
  const std::vector<Diagonal> diagonal = diagonals({});
  const std::vector<Value> step = steps({});
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    for (std::size_t k = 0; k < step.size(); ++k) {
      if (const auto fit = signs_of(all, i, k)) {
        found.push_back({block_words(diagonal[i].words, step[k].words), *fit});
      }
    }
  }
  if (found.size() != 1) return;
  const auto& [words, signs] = found.front();
  if (!words.empty()) {
    add_formula(sentences, "The 3x3 block of your V",
                (are_all(signs, 1) ? "" : "in absolute values ") + words);
  }
  const std::string negative = entries_with(-1, signs), zero = entries_with(0, signs);
  if (are_all(signs, -1)) {
    sentences.push_back("The whole 3x3 block of your V has the other sign.");
  } else if (!negative.empty()) {
    sentences.push_back("The other sign in every question: " + negative + ".");
  }
  if (!zero.empty()) sentences.push_back("Zero in every question: " + zero + ".");
}

}  // namespace

Words formulas_of_part2(const std::vector<Asked>& all) {
  Words sentences;
  add_block(sentences, all);
  add_border(sentences, all, "The last column of your V", range(12, 4));
  add_border(sentences, all, "The last row of your V", {3, 7, 11, 15});
  for (const int row : {0, 1, 2}) add_row_of_p(sentences, all, row);
  add_border(sentences, all, "Your p(3)", {19});
  return sentences;
}

}  // namespace bounce::tests
