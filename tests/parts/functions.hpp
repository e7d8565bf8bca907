// The function that each part asks for, by the part's number: whoever calls them reads this list.
#pragma once

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

// BOUNCE_FUNCTIONS(X) is X(number, function) for each of them.
#define BOUNCE_FUNCTIONS(X) \
  X(1, get_contacts)        \
  X(2, form_lcp)            \
  X(3, step)                \
  X(4, simulate)
