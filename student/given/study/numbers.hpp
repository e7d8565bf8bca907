// Given: numbers as a reader wants them.
#pragma once

#include <string>

namespace bounce::study {

// Three digits at most, as "%.3g" has them, or as `format` says; 120 and not 1.2e+02.
std::string number(double x, const char* format = "%.3g");

// Two digits, and commas: "80,000".
std::string rounded(double x);

// "1.2 mm": three digits at most, and a unit that suits.
std::string length(double metres);

}  // namespace bounce::study
