// Colours, as far as the terminal has them.
#pragma once

#include <string>

namespace bounce::check {

struct Style {
  std::string bold, red, green, dim, plain;
};

const Style& style();

}  // namespace bounce::check
