#include "findings.hpp"

namespace bounce::tests {

constexpr std::size_t kMostTraits = 3;  // a list of more tells nothing apart

Patterns where(const WrongPart& part, const std::vector<Number>& numbers) {
  using Questions = Eigen::Array<bool, Eigen::Dynamic, 1>;
  const auto count = static_cast<Eigen::Index>(part.cases.size());
  Questions wrong = Questions::Zero(count), fewest = Questions::Ones(count);
  for (const Number& n : numbers) wrong(Eigen::Index(n.question)) = true;
  // Few right questions may differ in this by chance.
  if (count - wrong.count() < Eigen::Index(kEnough)) return {};
  std::vector<Alternative>
      traits;  // what is true of all wrong questions, and of the fewest right ones
  const Row* of = nullptr;
  const std::string block = "where " + std::to_string(part.part);
  for (const Row& row : rows_of(block)) {
    for (const Alternative& trait : alternatives(row.at("traits"))) {
      const Questions is = value(trait.formula, part.columns) != 0;
      if ((wrong && !is).any() || is.all() || is.count() > fewest.count()) continue;
      if (traits.empty() || is.count() < fewest.count()) {
        traits.clear();
        fewest = is;
        of = &row;
      }
      if (of == &row && (is == fewest).all()) traits.push_back(trait);
    }
  }
  if (traits.empty() || traits.size() > kMostTraits || 4 * wrong.count() < 3 * fewest.count())
    return {};
  const std::string all = std::to_string(fewest.count()), some = std::to_string(wrong.count());
  Words words, ids;
  for (const Alternative& trait : traits) {
    words.push_back(trait.words);
    ids.push_back(trait.id);
  }
  return {{"where", {joined(words), all == some ? "all " + all : some + " of " + all}, ids}};
}

}  // namespace bounce::tests
