// Fits the rows of tables.txt to the answers.
#include <algorithm>
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

// The words of the one alternative that fits the target; empty if none or several do.
std::string fitting_one(const Asked& all, const std::string& target, const std::string& each) {
  Words found;
  for (const Alternative& one : alternatives(each)) {
    if (fits(all, with({"", target}, "{each}", one).formula)) found.push_back(one.words);
  }
  return found.size() == 1 ? found[0] : "";
}

// Sums without 0, and what needs no words.
std::string tidied(std::string text) {
  static const std::pair<const char*, const char*> shorter[] = {
      {"(0 + ", "("},
      {" + 0)", ")"},
      {"+ -", "- "},
      {"J_n^T (0)", "0"},
      {"J_t^T (0)", "0"},
      {", and with the forces' change of (v_x, v_y, omega) multiplied by (1, 1, 1)", ""},
      {", and with the forces' change of (v_x, v_y, omega) multiplied by (m, m, m r_g^2)",
       ", and without M^-1 before the forces"},
      {"that , and", "that"},
      {" and dt for dt", ""},
      {"the right M^-1 and ", ""},
      {", its entries by rows multiplied by (1, 1, 1, 1, 1, 1, 1, 1, 1)", ""},
      {"  ", " "},
      {" .", "."}};
  text = "(" + text + ")";
  for (const auto& [from, to] : shorter) text = replaced(text, from, to);
  return text.substr(1, text.size() - 2);
}

// The words of each choice from the row's lists that fits.
Words matches(const Row& row, const Asked& all) {
  const std::string list = text_of(row, "each");
  Words found;
  for (const Alternative& choice : choices(row)) {
    const Words of = targets(choice.formula);
    Words each;
    const bool fit = std::all_of(of.begin(), of.end(), [&](const std::string& target) {
      if (list.empty()) return fits(all, target);
      each.push_back(fitting_one(all, target, list));
      return !each.back().empty();
    });
    if (fit) found.push_back(tidied(replaced(choice.words, "{each}", joined(each, ", "))));
  }
  return found;
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
  Words words = matches(row, all);
  if (words.size() == 2 && row.count("each") + row.count("every") == 0)
    words = {"either " + joined(words, " or ")};
  if (words.size() > 1 && row.count("every") == 0) return;
  for (const std::string& one : words)
    sentences.push_back(tidied(replaced(row.at("say"), "{}", one)));
}

}  // namespace

Words formulas(const WrongPart& part, const std::string& rows) {
  if (!std::all_of(part.got.begin(), part.got.end(), is_finite)) return {};
  const Columns& got = part.columns;
  const Columns right = columns_of(part.part, part.cases, part.right, part.right);
  Words sentences;
  const std::string block = rows + std::to_string(part.part);
  for (const Row& row : rows_of(block)) {
    const std::string where = row.count("where") > 0 ? row.at("where") : "1";
    if (row.count("otherwise") == 0 || sentences.empty())
      add_row(sentences, row, {got, right, value(where, got)});
  }
  return sentences;
}

}  // namespace bounce::tests
