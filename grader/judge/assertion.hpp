// Finds the message of a failed assertion of Eigen or libstdc++ in the last printed text.
#pragma once

#include <string>
#include <string_view>

namespace bounce::judge {

// "an assertion failed (File.h:12): what", or empty. Takes linear time, whatever a submission has
// printed.
std::string assertion_in(std::string_view print);

}  // namespace bounce::judge
