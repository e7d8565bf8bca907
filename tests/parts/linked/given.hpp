// Right answers in place of earlier parts, as numbers that the solution gave to what the public
// cases lead to. They are in given.json, beside the public fixtures.
#pragma once

#include <bounce/types.hpp>
#include <vector>

namespace bounce::tests {

// The numbers of the part's answer, column by column, to these numbers of a question. Throws
// std::runtime_error if it isn't recorded.
const double* given_answer(int part, const std::vector<double>& question);

// The same, to the parameters and what else the part is asked.
template <class... Arguments>
const double* given(int part, const Parameters& p, const Arguments&... arguments) {
  std::vector<double> question{p.l,     p.m,     p.mu, p.epsilon, p.g.x(),
                               p.g.y(), p.g.z(), p.dt, p.delta,   static_cast<double>(p.T)};
  (question.insert(question.end(), arguments.data(), arguments.data() + arguments.size()), ...);
  return given_answer(part, question);
}

}  // namespace bounce::tests
