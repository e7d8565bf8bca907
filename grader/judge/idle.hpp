// Does a program wait, or is it only slow? A busy machine keeps a program from its CPU, too; but
// then it is ready to run, and a program that waits isn't.
#pragma once

#include <sys/types.h>

#include <optional>

namespace bounce::judge {

// The CPU time, in clock ticks, that a process and all its descendants have used; empty where one
// of them runs, or is ready to, or where this system doesn't tell.
std::optional<long> ticks_if_all_wait(pid_t pid);

}  // namespace bounce::judge
