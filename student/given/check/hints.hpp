// Opens the hint for the first check that fails, a stage at a time.
#pragma once

#include "parts.hpp"

namespace bounce::check {

void hint(const Run& run);

// The hint's heading for a check: "1.1 The height of the lowest corner".
std::string heading_of(const Check& check);

}  // namespace bounce::check
