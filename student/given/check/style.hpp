// Colours and signs, as far as the terminal has them.
#pragma once

#include <string>

namespace bounce::check {

struct Style {
  std::string bold, red, green, dim, plain;
  std::string right, wrong;
};

const Style& style();

}  // namespace bounce::check
