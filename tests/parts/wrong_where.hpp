// Finds what wrong cases have in common, and right ones don't have.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cases.hpp"

namespace bounce::tests {

// "Wrong only where ...", for the cases with these indices. Empty if all or too few are right, or
// if nothing sets the wrong ones apart.
std::string where(int part, const std::vector<Case>& cases, const std::set<std::size_t>& wrong);

}  // namespace bounce::tests
