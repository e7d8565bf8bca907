// Given: numbers as a reader wants them.
#pragma once

#include <string>

namespace bounce::study {

// Three digits at most, as "%.3g" has them, or as `format` says; 120 and not 1.2e+02.
std::string number(double x, const char* format = "%.3g");

// "1.2 mm": three digits at most, and a unit that suits.
std::string length(double metres);

}  // namespace bounce::study
