#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "expression.hpp"
#include "findings.hpp"
#include "formula_table.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kRounding = 1e-10;

// --- what a question's formulas are made of ---

// A question, with what stands for a name in a formula: with the part's answer, and the right one.
struct Asked {
  Symbols got, right;
};

void add(Symbols& symbols, const std::string& name, const VectorXd& numbers) {
  for (Index i = 0; i < numbers.size(); ++i) symbols[name + std::to_string(i)] = numbers(i);
}

// The rows of V's block, V0 to V8; an entry is (s/m + t/inertia) dt.
void add_block(Symbols& symbols, const Jacobian& J, const VectorXd& numbers) {
  const Vector3 columns[] = {J.col(1), -J.col(0), J.col(0)};  // of J_hat, eq. (7)
  for (Index k = 0; k < 9; ++k) {
    const Index i = k / 3, j = k % 3;
    const std::string number = std::to_string(k);
    symbols["V" + number] = numbers(i + 4 * j);
    symbols["s" + number] = columns[i].head(2).dot(columns[j].head(2));
    symbols["t" + number] = columns[i](2) * columns[j](2);
  }
}

// The angle by which the answer's arm is turned from the right one; far is 1 if it differs
// otherwise.
void add_turn(Symbols& symbols, const VectorXd& right, const VectorXd& got) {
  const double x = right(5), y = -right(2), got_x = got(5), got_y = -got(2);
  const double turn = std::atan2(x * got_y - y * got_x, x * got_x + y * got_y);
  symbols["turn"] = std::abs(turn) < kRounding ? 0 : turn;
  symbols["far"] =
      !same(std::hypot(x, y), std::hypot(got_x, got_y)) || !same(got(6) - right(6), got_y - y);
}

// The answer's numbers are a0, a1 ... and the right ones r0, r1 ...; 0, 1 and 2 after a name stand
// for x, y and theta: q, v and g are the question's, c is the forces' change of v.
Symbols symbols_of(int part, const Case& c, const VectorXd& right, const VectorXd& numbers) {
  const Parameters& p = c.params;
  const Corner r = part == 1 ? Corner{right(5), -right(2)} : lowest_corner(c.q(2), p.l);
  Symbols all{{"l", p.l},
              {"m", p.m},
              {"mu", p.mu},
              {"epsilon", p.epsilon},
              {"dt", p.dt},
              {"delta", p.delta},
              {"inertia", p.m * p.l * p.l / 6},
              {"pi", std::numbers::pi},
              {"x", c.q(0)},
              {"y", c.q(1)},
              {"theta", c.q(2)},
              {"r_x", r.x},
              {"r_y", r.y},
              {"phi", c.q(1) + r.y},
              {"v_t", c.J.col(0).dot(c.v)},
              {"v_n", c.J.col(1).dot(c.v)},
              {"g_t", c.J.col(0).dot(p.g)},
              {"g_n", c.J.col(1).dot(p.g)},
              {"touching", c.corner.rfind("corner", 0) == 0},
              {"flying", c.corner.rfind("no corner", 0) == 0},
              {"long", p.T >= 4}};
  if (part == 1) add_turn(all, right, numbers);
  add(all, "q", c.q);
  add(all, "v", c.v);
  add(all, "g", p.g);
  add(all, "x", Vector3::UnitX());
  add(all, "y", Vector3::UnitY());
  add(all, "z", Vector3::UnitZ());
  add(all, "a", numbers);
  add(all, "r", right);
  if (part == 2) add_block(all, c.J, numbers);
  if (part < 3) return all;
  add(all, "m", numbers.head(3));
  add(all, "n", numbers.segment(3, 3));
  add(all, "c", right.segment(3, 3) - c.v - p.dt * p.g);
  return all;
}

// --- reading rows ---

struct Alternative {
  std::string words, formula;
};

std::string trimmed(const std::string& text) {
  const std::size_t from = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

Words split(const std::string& list) {
  Words all;
  for (std::size_t at = 0, end = 0; end != list.npos && !list.empty(); at = end + 1) {
    end = list.find(';', at);
    all.push_back(trimmed(list.substr(at, end - at)));
  }
  return all;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::vector<Alternative> alternatives(const std::string& list) {
  std::vector<Alternative> all;
  for (const std::string& text : split(list)) {
    const std::size_t at = text.find(":=");
    all.push_back(at == text.npos ? Alternative{text, text}
                                  : Alternative{trimmed(text.substr(0, at)), text.substr(at + 2)});
  }
  return all;
}

Alternative with(const Alternative& row, const std::string& place, const Alternative& one) {
  return {replaced(row.words, place, one.words),
          replaced(row.formula, place, "(" + one.formula + ")")};
}

// The row's words and formula with each choice from its lists.
std::vector<Alternative> choices(const Row& row) {
  std::vector<Alternative> all{{row.words, row.numbers}};
  for (std::size_t i = 0; i < row.lists.size(); ++i) {
    std::vector<Alternative> more;
    for (const Alternative& before : all) {
      for (const Alternative& one : alternatives(row.lists[i]))
        more.push_back(with(before, "{" + std::to_string(i) + "}", one));
    }
    all = more;
  }
  return all;
}

struct Target {
  std::string number, formula;
};

// "a0 = FORMULA; a1 = FORMULA", with each component for a #. Some targets have no formula.
std::vector<Target> targets(const std::string& numbers) {
  std::vector<Target> all;
  for (const std::string& text : split(numbers)) {
    const std::size_t at = text.find(" = ");
    const Target target{text.substr(0, at), at == text.npos ? "" : text.substr(at + 3)};
    const bool is_one = text.find('#') == text.npos;
    for (int k = 0; k < (is_one ? 1 : target.number == "V#" ? 9 : 3); ++k) {
      const std::string number = std::to_string(k);
      all.push_back({replaced(target.number, "#", number), replaced(target.formula, "#", number)});
    }
  }
  return all;
}

// --- fitting ---

bool fits(const std::vector<Asked>& all, const std::string& number, const std::string& formula) {
  return std::all_of(all.begin(), all.end(), [&](const Asked& a) {
    return same(value(number, a.got), value(formula, a.got));
  });
}

bool is_right(const std::vector<Asked>& all, const std::string& number) {
  return std::all_of(all.begin(), all.end(), [&](const Asked& a) {
    return same(value(number, a.got), value(number, a.right));
  });
}

// "l^2 / 0.16" for "l^2 / ?": the number by which the alternative fits. Empty if none does.
std::string with_number(const std::vector<Asked>& all, const Target& target,
                        const Alternative& one) {
  const auto formula = [&](const std::string& factor) {
    return replaced(target.formula, "{each}", "(" + factor + ")");
  };
  double largest = 0, number = 0;
  for (const Asked& a : all) {
    const double none = value(formula("0"), a.got);
    const double due = value(formula(replaced(one.formula, "?", "1")), a.got) - none;
    if (!(std::abs(due) > largest)) continue;
    largest = std::abs(due);
    number = due / (value(target.number, a.got) - none);
  }
  char exact[32];
  std::snprintf(exact, sizeof exact, "(%.17g)", number);
  const bool fit = std::isfinite(number) && number != 0 &&
                   fits(all, target.number, formula(replaced(one.formula, "?", exact)));
  return fit ? replaced(one.words, "?", digits(number)) : "";
}

// The words of the one alternative that fits the target; empty if none or several do.
std::string fitting_one(const std::vector<Asked>& all, const Target& target,
                        const std::string& each) {
  Words found, with_numbers;
  for (const Alternative& one : alternatives(each)) {
    if (one.words.find('?') != std::string::npos) {
      with_numbers.push_back(found.empty() ? with_number(all, target, one) : "");
    } else if (fits(all, target.number, with({"", target.formula}, "{each}", one).formula)) {
      found.push_back(one.words);
    }
  }
  if (!found.empty()) return found.size() == 1 ? found[0] : "";
  std::erase(with_numbers, "");
  return with_numbers.empty() ? "" : with_numbers[0];
}

// What fits: its words, and those of {each} for each target.
struct Match {
  std::string words;
  Words each;
};

std::vector<Match> fits(const Row& row, const std::vector<Asked>& all) {
  std::vector<Match> found;
  for (const Alternative& choice : choices(row)) {
    const std::vector<Target> of = targets(choice.formula);
    Words each;
    const bool fit = std::all_of(of.begin(), of.end(), [&](const Target& target) {
      if (row.each.empty()) return fits(all, target.number, target.formula);
      each.push_back(fitting_one(all, target, row.each));
      return !each.back().empty();
    });
    if (fit) found.push_back({replaced(choice.words, "{each}", joined(each, ", ")), each});
  }
  return found;
}

// --- sentences ---

// Sums without 0, and what needs no words.
std::string tidied(std::string text) {
  static const std::pair<const char*, const char*> shorter[] = {
      {"(0 + ", "("},
      {" + 0)", ")"},
      {"+ -", "- "},
      {"J_n^T (0)", "0"},
      {"J_t^T (0)", "0"},
      {", and with the forces' change of (v_x, v_y, omega) multiplied by (1, 1, 1)", ""},
      {"that , and", "that"},
      {" and dt for dt", ""},
      {"the right M^-1 and ", ""},
      {"  ", " "},
      {" .", "."}};
  text = "(" + text + ")";
  for (const auto& [from, to] : shorter) text = replaced(text, from, to);
  return text.substr(1, text.size() - 2);
}

// "Your phi is min(1, phi) in every question.": a number of the answers that is right between two
// bounds, and one of them elsewhere.
std::string between_bounds(const std::vector<Asked>& all, const std::string& number,
                           const std::string& name) {
  double least = -INFINITY, most = INFINITY;
  std::size_t wrong = 0;
  for (const Asked& a : all) {
    const double got = value(number, a.got), right = value(number, a.right);
    if (same(got, right)) continue;
    (got > right ? least : most) = got;
    ++wrong;
  }
  if (wrong < kEnough || all.size() - wrong < kEnough) return "";
  for (const Asked& a : all) {
    const double bounded = std::min(std::max(value(number, a.right), least), most);
    if (!same(value(number, a.got), bounded)) return "";
  }
  std::string words = name;
  if (std::isfinite(least)) words = "max(" + digits(least) + ", " + words + ")";
  if (std::isfinite(most)) words = "min(" + digits(most) + ", " + words + ")";
  return "Your " + name + " is " + words + " in every question.";
}

// Whether these questions are enough, and the row's conditions hold in them.
bool is_for(const Row& row, const std::vector<Asked>& all) {
  if (all.size() < kEnough) return false;
  const auto right = [&](const std::string& number) { return is_right(all, number); };
  const Words must_be = split(row.right);
  Words wrong = split(row.wrong);
  if (wrong.empty()) {
    for (const Target& target : targets(row.numbers)) wrong.push_back(target.number);
  }
  return std::all_of(must_be.begin(), must_be.end(), right) &&
         !std::all_of(wrong.begin(), wrong.end(), right);
}

void add_row(Words& sentences, const Row& row, const std::vector<Asked>& questions) {
  std::vector<Asked> all;
  std::copy_if(questions.begin(), questions.end(), std::back_inserter(all),
               [&](const Asked& a) { return value(row.where, a.got) != 0; });
  if (!is_for(row, all)) return;
  std::vector<Match> found;
  if (!row.sentence.empty()) found = fits(row, all);
  const std::size_t most = row.each.empty() ? 2 : 1;
  if (!found.empty() && found.size() <= most) {
    Words words;
    for (const Match& match : found) words.push_back(tidied(match.words));
    const std::string either = words.size() == 2 ? "either " : "";
    sentences.push_back(tidied(replaced(row.sentence, "{}", either + joined(words, " or "))));
  }
  const Words names = split(row.bounds);
  for (std::size_t i = 0; found.empty() && i < names.size(); ++i) {
    const Target target = targets(row.numbers)[i];
    const std::string sentence = between_bounds(all, target.number, names[i]);
    if (!sentence.empty()) sentences.push_back(sentence);
  }
}

std::string entries_with(const std::string& sign, const Words& signs) {
  Words names;
  for (std::size_t k = 0; k < signs.size(); ++k) {
    if (signs[k] != sign) continue;
    names.push_back("V(" + std::to_string(k / 3) + ", " + std::to_string(k % 3) + ")");
  }
  return joined(names);
}

void add_block(Words& sentences, const std::vector<Asked>& all) {
  std::vector<Match> found;
  for (const Row& row : kBlock) {
    if (!is_for(row, all)) return;
    for (const Match& fit : fits(row, all)) found.push_back(fit);
  }
  if (found.size() != 1) return;
  const Words& signs = found[0].each;
  const std::string words = tidied(found[0].words);
  const std::string negative = entries_with("-1", signs), zero = entries_with("0", signs);
  if (signs[0] == "0" && signs[4] == "0" && signs[8] == "0") return;
  if (words != "the right M^-1") {
    sentences.push_back(
        replaced(kBlock[0].sentence, "{}",
                 std::string(negative.empty() && zero.empty() ? "" : "in absolute values ") +
                     "J_hat^T M^-1 J_hat dt with " + words));
  }
  if (std::count(signs.begin(), signs.end(), "-1") == 9) {
    sentences.push_back("The whole 3x3 block of your V has the other sign.");
  } else if (!negative.empty()) {
    sentences.push_back("The other sign in every question: " + negative + ".");
  }
  if (!zero.empty()) sentences.push_back("Zero in every question: " + zero + ".");
}

}  // namespace

Words formulas(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
               const std::vector<Answer>& got) {
  if (kRows.count(part) == 0) return {};
  std::vector<Asked> all;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (!is_finite(right[k], got[k])) return {};
    const auto symbols = [&](const VectorXd& numbers) {
      return symbols_of(part, cases[k], right[k].numbers, numbers);
    };
    all.push_back({symbols(got[k].numbers), symbols(right[k].numbers)});
  }
  Words sentences = part == 4 ? trajectory(cases, right, got) : Words();
  if (part == 2) add_block(sentences, all);
  for (const Row& row : kRows.at(part)) {
    if (!row.otherwise || sentences.empty()) add_row(sentences, row, all);
  }
  return sentences;
}

}  // namespace bounce::tests
