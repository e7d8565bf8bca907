// How simple a case is, and what there is to say of the simplest one in which a part is wrong.
#pragma once

#include <utility>
#include <vector>

#include "checks.hpp"

namespace bounce::tests {

// A number of a case, and what it is in the simplest case: the assignment's, or 0.
struct Entry {
  double* value;
  double usual;
  bool is_angle = false;
};

// The numbers of the parameters, T apart, and of what is asked.
std::vector<Entry> numbers_in(Case& c);

// How many digits it takes to write a number; an angle may be written in degrees.
int digits_of(const Entry& number);

// How many numbers aren't the simplest; T, of a trajectory; how long all are, written down. The
// less, the simpler.
using Complexity = std::vector<int>;
Complexity complexity(Case c);

words::Question question_of(const Case& c);

// What the first wrong quantity of a case shows. The asker gives the right answers of earlier parts
// on the way.
words::Smallest smallest_of(Asker& asker, const Case& c, const Problem& problem);

template <class Matrix>
auto rows(const Matrix& m) {
  std::vector<std::vector<typename Matrix::Scalar>> all;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    all.emplace_back();
    for (Eigen::Index j = 0; j < m.cols(); ++j) all.back().push_back(m(i, j));
  }
  return all;
}

}  // namespace bounce::tests
