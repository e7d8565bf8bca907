// The filters of system calls in a box.
#pragma once

namespace bounce::box {

// For a submission: allows what a numerical program needs, and threads. It finds no file, and what
// it writes to one goes nowhere; its standard input has to be /dev/null for that, open to write,
// too. Calls that concern other programs, connections or devices end it with SIGSYS, which names
// the call. If it is built with sanitizers, these may read files.
void restrict_to_submission_calls(bool sanitized);

// Becomes the command, and returns if it can't, with errno. With the filter above, this is the only
// way to start a program.
void start(char* const* command, char* const* environment);

// For the guard of a box, which waits, kills, and passes out one file.
void restrict_to_guard_calls();

// For the toolchain, which must read, write and start its own programs: forbids calls that concern
// connections, other programs and the system.
void forbid_non_compiler_calls();

}  // namespace bounce::box
