#include <algorithm>

#include "findings.hpp"

namespace bounce::tests {

std::string where(const WrongPart& part, const std::set<std::size_t>& wrong) {
  const auto count = static_cast<Eigen::Index>(part.cases.size());
  const auto of_wrong = static_cast<Eigen::Index>(wrong.size());
  // Few right questions may differ in this by chance.
  if (of_wrong == 0 || count - of_wrong < Eigen::Index(kEnough)) return "";
  Words words;  // of what is true of all wrong questions, and of the fewest right ones
  const Row* of = nullptr;
  Eigen::Array<bool, Eigen::Dynamic, 1> fewest = Eigen::Array<bool, Eigen::Dynamic, 1>::Ones(count);
  for (const Row& row : rows_of("where " + std::to_string(part.part))) {
    for (const auto& [name, formula] : alternatives(row.at("traits"))) {
      const Eigen::Array<bool, Eigen::Dynamic, 1> is = value(formula, part.columns) != 0;
      const bool has_wrong = std::all_of(wrong.begin(), wrong.end(),
                                         [&](std::size_t k) { return is(Eigen::Index(k)); });
      if (!has_wrong || is.all() || is.count() > fewest.count()) continue;
      if (words.empty() || is.count() < fewest.count()) {
        words.clear();
        fewest = is;
        of = &row;
      }
      if (of == &row && (is == fewest).all()) words.push_back(name);
    }
  }
  const Eigen::Index such = fewest.count();
  if (words.empty() || 4 * of_wrong < 3 * such) return "";
  const std::string all = std::to_string(such), some = std::to_string(of_wrong);
  return "Wrong only where " + joined(words) + ", in " +
         (all == some ? "all " + all : some + " of " + all) + " such public questions.";
}

}  // namespace bounce::tests
