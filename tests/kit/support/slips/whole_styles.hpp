// Styles in which all four parts are written.
#pragma once

#include "part1.hpp"
#include "part2.hpp"
#include "part3.hpp"

namespace slips {

struct Style {
  GetContacts get_contacts;
  FormLcp form_lcp;
  Step step;
  Simulate simulate;
};

const Style& classes();        // that hold the state of the square
const Style& contact_frame();  // impulses along the ground and upwards

}  // namespace slips
