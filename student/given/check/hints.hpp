// Opens the hint for the first check that fails, a stage at a time.
#pragma once

#include "parts.hpp"

namespace bounce::check {

void hint(const Run& run);

// "1.1 The height of the lowest corner": the heading of the hint for what is told of the mistake,
// or else for the check.
std::string heading_of(const Part& part, const Check& check, const std::string& mistake);

}  // namespace bounce::check
