// Ends the program when it works too long: an endless loop has to end without help from outside,
// since not every system has a command for it.
#pragma once

#include <functional>

namespace bounce::tests {

// After 3 s of work, or a minute of waiting, calls last_words and ends the program.
void limit_time(const std::function<void()>& last_words);

void lift_time_limit();

}  // namespace bounce::tests
