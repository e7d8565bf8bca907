// Given: what the measured impacts say of your form_lcp.
#pragma once

#include "impacts.hpp"

namespace bounce::real {

// "0.095 m/s"
std::string speed(double metres_per_second);

// is_wrong: checks of part 2 fail.
std::string sentence(const Measured& measured, const Result& mine, bool is_wrong);

}  // namespace bounce::real
