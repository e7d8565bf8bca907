// Ends the program if it takes too long. It must do so itself, because not every system has the
// command timeout.
#pragma once

#include <functional>

namespace bounce::tests {

// After 3 s of CPU time, or a minute of elapsed time, calls last_words and ends the program.
void limit_time(const std::function<void()>& last_words);

void lift_time_limit();

}  // namespace bounce::tests
