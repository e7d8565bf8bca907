// Parts 3 and 4 in several styles, with slips as switches. Earlier parts are the solution's.
#pragma once
#include "slips.hpp"
namespace slips {
using Step = State (*)(const Vector3&, const Vector3&, const Parameters&);
const std::map<std::string, Step>& part3_styles();
using Simulate = Trajectory (*)(const Vector3&, const Vector3&, const Parameters&);
const std::map<std::string, Simulate>& part4_styles();
}  // namespace slips
