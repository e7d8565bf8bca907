// Fits the rows of tables.txt to the answers.
#include <algorithm>
#include <utility>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

// --- reading rows ---

Alternative with(const Alternative& row, const std::string& place, const Alternative& one) {
  return {"", replaced(row.words, place, one.words),
          replaced(row.formula, place, "(" + one.formula + ")")};
}

// The row's words and numbers with each choice from its lists.
std::vector<Alternative> choices(const Row& row) {
  std::string words = "{0}";
  for (const char* line : {"words", "pieces", "sum"}) {
    if (row.count(line) > 0) words = row.at(line);
  }
  std::vector<Alternative> all{{"", words, text_of(row, "numbers")}};
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
    if (fits(all, with({"", "", target}, "{each}", one).formula)) found.push_back(one.words);
  }
  return found.size() == 1 ? found[0] : "";
}

// "q + dt v - (0, delta, 0)" of its terms, without 0; "0" if nothing is left.
std::string sum_of(const Words& terms) {
  std::string sum;
  for (const std::string& term : terms) {
    if (term == "0") continue;
    const bool is_minus = term[0] == '-' && !sum.empty();
    sum += is_minus ? " - " + term.substr(1) : (sum.empty() ? "" : " + ") + term;
  }
  return sum.empty() ? "0" : sum;
}

// "the other sign in (0, 1) and (1, 0)", of factors by rows; empty if all are 1.
std::string entries_of(const Words& factors) {
  Words said;
  for (const auto& [factor, words] :
       {std::pair("-1", "the other sign in "), std::pair("0", "0 in ")}) {
    Words entries;
    for (std::size_t k = 0; k < factors.size(); ++k) {
      if (factors[k] != factor) continue;
      entries.push_back("(" + std::to_string(k / 3) + ", " + std::to_string(k % 3) + ")");
    }
    if (!entries.empty()) said.push_back(words + joined(entries));
  }
  return joined(said, ", and ");
}

// What the row says of a choice, with what fits for {each}.
std::string words_of(const Row& row, const std::string& choice, const Words& each) {
  const std::string factors = joined(each, ", ");
  if (row.count("sum") > 0) {
    const std::string sum = sum_of(split(choice));
    return row.count("of") == 0 || sum == "0" ? sum : row.at("of") + " (" + sum + ")";
  }
  if (row.count("pieces") == 0) return replaced(choice, "{each}", factors);
  const bool all_are_1 = std::count(each.begin(), each.end(), "1") == std::ptrdiff_t(each.size());
  Words pieces = split(replaced(choice, "{entries}", entries_of(each)));
  std::erase_if(pieces, [&](const std::string& piece) {
    return piece.empty() || (all_are_1 && piece.find("{each}") != piece.npos);
  });
  return replaced(joined(pieces), "{each}", factors);
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
    if (fit) found.push_back(words_of(row, choice.words, each));
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

void add_row(Patterns& patterns, const Row& row, const Asked& all) {
  if (!is_for(row, all)) return;
  Words words = matches(row, all);
  if (words.size() == 2 && row.count("each") + row.count("every") == 0)
    words = {"either " + joined(words, " or ")};
  if (words.size() > 1 && row.count("every") == 0) return;
  for (const std::string& one : words) patterns.push_back({row.at("id"), {one}});
}

}  // namespace

Patterns formulas(const WrongPart& part, const std::string& rows) {
  if (!std::all_of(part.got.begin(), part.got.end(), is_finite)) return {};
  const Columns& got = part.columns;
  const Columns right = columns_of(part.part, part.cases, part.right, part.right);
  Patterns patterns;
  const std::string block = rows + std::to_string(part.part);
  for (const Row& row : rows_of(block)) {
    const std::string where = row.count("where") > 0 ? row.at("where") : "1";
    if (row.count("otherwise") == 0 || patterns.empty())
      add_row(patterns, row, {got, right, value(where, got)});
  }
  return patterns;
}

}  // namespace bounce::tests
