// The functions under test that are linked into a student's own test program. A program has those
// of one part, and of no other.
#pragma once

#include <string>

#include "../functions.hpp"

namespace bounce::tests {

// A part's function where it is linked in, else null: linked<&bounce::step>.
template <auto* function>
inline decltype(function) linked = nullptr;

// "134": the numbers of the parts that are linked in.
inline std::string linked_parts;

}  // namespace bounce::tests
