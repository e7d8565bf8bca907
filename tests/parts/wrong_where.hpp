// In which cases answers are wrong: what these have, and the right ones haven't.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cases.hpp"

namespace bounce::tests {

// "Wrong only where ...", of the cases with these indices; empty where all or too few are right, or
// where nothing sets the wrong ones apart.
std::string where(int part, const std::vector<Case>& cases, const std::set<std::size_t>& wrong);

}  // namespace bounce::tests
