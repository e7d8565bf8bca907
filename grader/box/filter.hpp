// Which system calls may be made in a box.
#pragma once

namespace bounce::box {

// For a submission: what a numerical program needs. A file isn't there, and what concerns other
// programs, connections or devices ends it with SIGSYS, which names the call.
void allow_only_what_numbers_need();

// For a submission that is built to check itself: also what the loader of its libraries and the
// checking need, which read files.
void allow_what_checked_numbers_need();

// For the guard of a box, which waits, kills, and hands out one file.
void allow_only_what_a_guard_needs();

// For the toolchain, which has to read, write and start its own programs: all but what concerns
// connections, other programs and the system.
void refuse_what_no_compiler_needs();

}  // namespace bounce::box
