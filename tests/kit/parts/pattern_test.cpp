// What is said of wrong answers that no known mistake explains. A row of patterns.txt has a name, a
// part and how its answers are made of the right ones, and below that what is said of them. In its
// formulas, those of findings.hpp, stand also: k, the question's place; size, how many numbers its
// answer has; and n, the place of one of them, for which # stands, too.
#include <cmath>
#include <regex>

#include "../../../grader/diagnosis/findings.hpp"
#include "expected_texts.hpp"
#include "known_part.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

// Answers that are changed one number after the other.
class Changed {
 public:
  explicit Changed(int part)
      : got(known_part(part).known.right),
        columns_(columns_of(part, known_part(part).cases, got, got)) {
    const auto count = static_cast<Index>(got.size());
    columns_["k"] = Column::LinSpaced(count, 0, static_cast<double>(count - 1));
    Column& size = columns_["size"] = Column::Zero(count);
    for (Index k = 0; k < count; ++k) size(k) = static_cast<double>(numbers(k).size());
  }

  // "a6 = m r6", or of each number, "a# = 0 if 5 < n"; other names are kept for what follows.
  void assign(const std::string& name, const std::string& formula, const std::string& condition) {
    const bool is_one = name.find('#') == std::string::npos;
    const int end = is_one ? 1 : static_cast<int>(columns_["size"].maxCoeff());
    for (int n = 0; n < end; ++n) {
      columns_["n"] = Column::Constant(columns_["k"].size(), n);
      set(with(name, n), value(with(formula, n), columns_), value(condition, columns_));
    }
  }

  std::vector<Answer> got;

 private:
  Eigen::VectorXd& numbers(Index k) { return got[static_cast<std::size_t>(k)].numbers; }

  static std::string with(const std::string& text, int n) {
    return std::regex_replace(text, std::regex("#"), std::to_string(n));
  }

  void set(const std::string& name, const Column& to, const Column& where) {
    Column& column = columns_[name];
    column = column.size() == 0 ? to : Column((where != 0).select(to, column));
    const bool is_number = std::regex_match(name, std::regex("a\\d+"));
    const Index n = is_number ? std::stoi(name.substr(1)) : 0;
    for (Index k = 0; k < column.size() && is_number; ++k) {
      if (n < numbers(k).size()) numbers(k)(n) = column(k);
    }
  }

  Columns columns_;
};

// For "part 1: a3 = r5; a5 = r3 if x < 0".
std::string told(const std::string& row) {
  const int part = row.at(5) - '0';
  const std::size_t end = row.rfind(" if ");
  Changed changed(part);
  for (const std::string& text : split(row.substr(7, end - 7))) {
    const std::size_t at = text.find(" = ");
    const std::string condition = end == std::string::npos ? "1" : row.substr(end + 4);
    changed.assign(text.substr(0, at), text.substr(at + 3), condition);
  }
  const KnownPart& asked = known_part(part);
  std::string sentences;
  for (const Pattern& pattern : patterns(part, asked.cases, asked.known.right, changed.got)) {
    sentences += sentence_of(pattern) + "\n";
  }
  return sentences;
}

TEST(pattern, SaysWhatIsTrueOfAllAnswersAndNothingElse) {
  std::ifstream file(BOUNCE_PARTS "/patterns.txt");
  Texts texts;
  std::string row;
  const auto finish = [&] {
    if (!row.empty()) texts.back().second += told(std::exchange(row, ""));
  };
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("--- ", 0) == 0) {
      texts.emplace_back(line.substr(4), "");
    } else if (line.rfind("  ", 0) == 0) {
      texts.back().second += line + "\n";
      row += (row.empty() ? "" : " ") + line.substr(2);
      continue;
    }
    finish();
  }
  expect_texts("patterns.txt", texts);
}

TEST(pattern, LeavesOutWhatIsNoNumberAndWhatThrew) {
  const KnownPart& asked = known_part(1);
  std::vector<Answer> got = asked.known.right;
  got[3] = {{}, "thrown"};
  got[4].numbers(6) = NAN;
  const auto all = patterns(1, asked.cases, asked.known.right, got);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(sentence_of(all[0]),
            "Correct in every public case that it answers: J_t and J_n; wrong: phi.");
  EXPECT_TRUE(patterns(1, asked.cases, asked.known.right, {}).empty());
}

}  // namespace
}  // namespace bounce::tests
