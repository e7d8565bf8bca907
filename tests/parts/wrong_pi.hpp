// Finds out whether part 1 writes pi with too few digits.
#pragma once

#include "wrong_numbers.hpp"

namespace bounce::tests {

// "Your arm is the right one, turned by a multiple of (3.14 - pi) / 4 in every question", if it is:
// corners that stand at quarters of pi, or an angle from which whole turns are taken off.
Words written_pi(const std::vector<Answer>& right, const std::vector<Answer>& got);

}  // namespace bounce::tests
