// Says where the program crashes: ./check looks up the line.
#pragma once

#include <string>

namespace bounce::tests {

// From here on, a signal that ends the program writes the addresses of its calls into the file, as
// the program's file has them, the innermost first, a line each. Does nothing on Windows.
void write_stack_of_crash(const std::string& file);

}  // namespace bounce::tests
