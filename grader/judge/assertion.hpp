// What a failed assertion of Eigen's or libstdc++'s says, found in the end of what was printed.
#pragma once

#include <string>
#include <string_view>

namespace bounce::judge {

// "an assertion failed (File.h:12): what", or nothing. A submission may have printed anything, so
// each character is looked at a bounded number of times.
std::string assertion_in(std::string_view print);

}  // namespace bounce::judge
