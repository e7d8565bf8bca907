// All four parts in one more style, written last: classes that hold the state of the square.
#pragma once

#include "part1.hpp"
#include "part2.hpp"
#include "part3.hpp"

namespace slips {

// All four parts in one style.
struct Style {
  GetContacts get_contacts;
  FormLcp form_lcp;
  Step step;
  Simulate simulate;
};

const Style& classes();

}  // namespace slips
