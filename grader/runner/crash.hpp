// Where a crash happened: the addresses on the stack, as one line on standard error. The grader
// turns them into the submission's file and line.
#pragma once

namespace bounce::runner {

inline constexpr char kStack[] = "stack of the crash:";

// From here on, a signal that ends the program says where first.
void tell_where_it_crashes();

}  // namespace bounce::runner
