// Fits the rows of tables.txt to the answers.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

// --- reading rows ---

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

Alternative with(const Alternative& row, const std::string& place, const Alternative& one) {
  return {replaced(row.words, place, one.words),
          replaced(row.formula, place, "(" + one.formula + ")")};
}

// The row's words and numbers with each choice from its lists.
std::vector<Alternative> choices(const Row& row) {
  std::vector<Alternative> all{
      {row.count("words") > 0 ? row.at("words") : "{0}", text_of(row, "numbers")}};
  for (const char* list : {"0", "1"}) {
    if (row.count(list) == 0) break;
    std::vector<Alternative> more, of_list = alternatives(row.at(list));
    for (const Alternative& before : all) {
      for (const Alternative& one : of_list)
        more.push_back(with(before, std::string("{") + list + "}", one));
    }
    all = more;
  }
  return all;
}

// "a0 = FORMULA", "a1 = FORMULA", with each component for a #.
Words targets(const std::string& numbers) {
  Words all;
  for (const std::string& text : split(numbers)) {
    const bool is_one = text.find('#') == text.npos;
    for (int k = 0; k < (is_one ? 1 : text[0] == 'V' ? 9 : 3); ++k)
      all.push_back(replaced(text, "#", std::to_string(k)));
  }
  return all;
}

std::string number_in(const std::string& target) { return target.substr(0, target.find(" = ")); }

// --- fitting ---

// What stands for the names in questions, with the part's answers and with the right ones; and in
// which of these questions a row's formulas hold, where they do.
struct Asked {
  const Columns &got, &right;
  Column of_row;

  // Whether it is so in each of the row's questions.
  bool each(const Column& is) const { return (is != 0 || of_row == 0).all(); }
};

bool fits(const Asked& all, const std::string& target) { return all.each(value(target, all.got)); }

bool is_right(const Asked& all, const std::string& target) {
  const std::string number = number_in(target);
  return all.each(are_same(value(number, all.got), value(number, all.right)));
}

// "l^2 / 0.16" for "l^2 / ?": the number by which the alternative fits. Empty if none does.
std::string with_number(const Asked& all, const std::string& target, const Alternative& one) {
  const auto with_factor = [&](const std::string& factor) {
    return replaced(target, "{each}", "(" + factor + ")");
  };
  const auto formula = [&](const std::string& factor) {
    return value(with_factor(factor).substr(target.find(" = ") + 3), all.got);
  };
  const Column none = formula("0"), due = formula(replaced(one.formula, "?", "1")) - none;
  const Column got = value(number_in(target), all.got) - none;
  Index largest = 0;
  (all.of_row != 0).select(due, 0.0).abs().maxCoeff(&largest);
  const double number = due(largest) / got(largest);
  char exact[32];
  std::snprintf(exact, sizeof exact, "(%.17g)", number);
  const bool fit = std::isfinite(number) && number != 0 &&
                   fits(all, with_factor(replaced(one.formula, "?", exact)));
  return fit ? replaced(one.words, "?", digits(number)) : "";
}

// The words of the one alternative that fits the target; empty if none or several do.
std::string fitting_one(const Asked& all, const std::string& target, const std::string& each) {
  Words found, with_numbers;
  for (const Alternative& one : alternatives(each)) {
    if (one.words.find('?') == std::string::npos) {
      if (fits(all, with({"", target}, "{each}", one).formula)) found.push_back(one.words);
    } else if (found.empty()) {
      with_numbers.push_back(with_number(all, target, one));
    }
  }
  std::erase(with_numbers, "");
  if (found.empty()) return with_numbers.empty() ? "" : with_numbers[0];
  return found.size() == 1 ? found[0] : "";
}

// What fits: its words, and those of {each} for each target.
struct Match {
  std::string words;
  Words each;
};

std::vector<Match> matches(const Row& row, const Asked& all) {
  const std::string list = text_of(row, "each");
  std::vector<Match> found;
  for (const Alternative& choice : choices(row)) {
    const Words of = targets(choice.formula);
    Words each;
    const bool fit = std::all_of(of.begin(), of.end(), [&](const std::string& target) {
      if (list.empty()) return fits(all, target);
      each.push_back(fitting_one(all, target, list));
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
std::string between_bounds(const Asked& all, const std::string& number, const std::string& name) {
  const Column got = value(number, all.got), right = value(number, all.right);
  const Column is_right = are_same(got, right);
  double least = -INFINITY, most = INFINITY;
  for (Index k = 0; k < got.size(); ++k) {
    if (all.of_row(k) != 0 && is_right(k) == 0) (got(k) > right(k) ? least : most) = got(k);
  }
  const bool holds = all.each(are_same(got, right.max(least).min(most)));
  const Index count = (all.of_row != 0).count(), wrong = (all.of_row != 0 && is_right == 0).count();
  if (!holds || wrong < Index(kEnough) || count - wrong < Index(kEnough)) return "";
  std::string words = name;
  if (std::isfinite(least)) words = "max(" + digits(least) + ", " + words + ")";
  if (std::isfinite(most)) words = "min(" + digits(most) + ", " + words + ")";
  return "Your " + name + " is " + words + " in every question.";
}

// Whether these questions are enough, and the row's conditions hold in them.
bool is_for(const Row& row, const Asked& all) {
  if ((all.of_row != 0).count() < Index(kEnough)) return false;
  const auto are_right = [&](const Words& numbers) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [&](const std::string& number) { return is_right(all, number); });
  };
  const std::string wrong = text_of(row, row.count("wrong") > 0 ? "wrong" : "numbers");
  return are_right(split(text_of(row, "right"))) && !are_right(targets(wrong));
}

void add_row(Words& sentences, const Row& row, const Asked& all) {
  if (!is_for(row, all)) return;
  const std::string say = text_of(row, "say");
  const std::vector<Match> found = say.empty() ? std::vector<Match>() : matches(row, all);
  Words words;
  for (const Match& match : found) words.push_back(tidied(match.words));
  const std::string either = words.size() == 2 ? "either " : "";
  if (words.size() == 1 || (words.size() == 2 && row.count("each") == 0))
    sentences.push_back(tidied(replaced(say, "{}", either + joined(words, " or "))));
  const Words names = split(text_of(row, "bounds")), numbers = split(text_of(row, "numbers"));
  for (std::size_t i = 0; found.empty() && i < names.size(); ++i) {
    const std::string sentence = between_bounds(all, number_in(numbers[i]), names[i]);
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

void add_block(Words& sentences, const Asked& all) {
  std::vector<Match> found;
  for (const Row& row : rows_of("block")) {
    if (!is_for(row, all)) return;
    for (const Match& match : matches(row, all)) found.push_back(match);
  }
  if (found.size() != 1) return;
  const Words& signs = found[0].each;
  const std::string words = tidied(found[0].words);
  const std::string negative = entries_with("-1", signs), zero = entries_with("0", signs);
  if (signs[0] == "0" && signs[4] == "0" && signs[8] == "0") return;
  if (words != "the right M^-1") {
    sentences.push_back("The 3x3 block of your V is " +
                        std::string(negative.empty() && zero.empty() ? "" : "in absolute values ") +
                        "J_hat^T M^-1 J_hat dt with " + words + " in every question.");
  }
  if (std::count(signs.begin(), signs.end(), "-1") == 9) {
    sentences.push_back("The whole 3x3 block of your V has the other sign.");
  } else if (!negative.empty()) {
    sentences.push_back("The other sign in every question: " + negative + ".");
  }
  if (!zero.empty()) sentences.push_back("Zero in every question: " + zero + ".");
}

}  // namespace

Words formulas(const WrongPart& part) {
  if (!std::all_of(part.got.begin(), part.got.end(), is_finite)) return {};
  const Columns& got = part.columns;
  const Columns right = columns_of(part.part, part.cases, part.right, part.right);
  Words sentences = part.part == 4 ? trajectory(part) : Words();
  if (part.part == 2) add_block(sentences, {got, right, value("1", got)});
  for (const Row& row : rows_of(std::to_string(part.part))) {
    const std::string where = row.count("where") > 0 ? row.at("where") : "1";
    if (row.count("otherwise") == 0 || sentences.empty())
      add_row(sentences, row, {got, right, value(where, got)});
  }
  return sentences;
}

}  // namespace bounce::tests
