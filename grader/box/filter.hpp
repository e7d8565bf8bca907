// The filters of system calls in a box.
#pragma once

namespace bounce::box {

// For a submission: allows what a numerical program needs, threads among it, and, if it has a
// folder of its own, files; if it hasn't, it finds none. Calls that concern other programs,
// connections or devices end it with SIGSYS, which names the call.
void allow_only_what_numbers_need(bool has_folder);

// For a submission that is built with sanitizers: also allows what these and the dynamic loader
// need, which read files.
void allow_what_checked_numbers_need();

// For the guard of a box, which waits, kills, and passes out one file.
void allow_only_what_a_guard_needs();

// For the toolchain, which must read, write and start its own programs: forbids calls that concern
// connections, other programs and the system.
void refuse_what_no_compiler_needs();

}  // namespace bounce::box
