#include "wrong_formulas.hpp"

#include "formula.hpp"

namespace bounce::tests {

Words formulas(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
               const std::vector<Answer>& got) {
  std::vector<Asked> all;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (!got[k].thrown.empty() || got[k].numbers.size() != right[k].numbers.size() ||
        !are_finite(got[k].numbers)) {
      return {};
    }
    all.push_back({cases[k], right[k].numbers, got[k].numbers});
  }
  return part == 1   ? formulas_of_part1(all)
         : part == 2 ? formulas_of_part2(all)
         : part == 3 ? formulas_of_part3(all)
         : part == 4 ? formulas_of_part4(all)
                     : Words();
}

}  // namespace bounce::tests
