// Part 1 in several styles, with the slips that students make in each as switches.
#pragma once
#include <functional>
#include "slips.hpp"
namespace slips {
using GetContacts = Contact (*)(const Vector3&, const Parameters&);
const std::map<std::string, GetContacts>& part1_styles();
}  // namespace slips
