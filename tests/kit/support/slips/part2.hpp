// Part 2 in several styles, with slips as switches.
#pragma once
#include "slips.hpp"
namespace slips {
using FormLcp = Lcp (*)(const Jacobian&, const Vector3&, const Parameters&);
const std::map<std::string, FormLcp>& part2_styles();
}  // namespace slips
