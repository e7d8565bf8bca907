// Finds the message of a failed assertion of Eigen or libstdc++ in the last printed text.
#pragma once

#include <string>
#include <string_view>

namespace bounce::judge {

// "an index is out of range", or "File.h:12: what" of another assertion; empty if there is none.
// Takes linear time, whatever a submission has printed.
std::string assertion_in(std::string_view print);

}  // namespace bounce::judge
