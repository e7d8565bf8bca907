// The guard of a box: a process of our own that stays outside of what it guards. It waits for it,
// counts its CPU time, ends what it leaves behind, and hands out the file that it has made.
#pragma once

#include <sys/types.h>

namespace bounce::box {

struct Guarding {
  void (*before)();      // called in the guard before the child may go on: its filter, or nothing
  void (*afterwards)();  // called in the guard when the child and all that it left are gone
};

// Forks. Returns in the child, once the guard is ready. In the guard: ends when the child does,
// with its exit status, or 128 + n after signal n; `kept` is the one descriptor that it keeps, or
// -1. When whoever started this process ends, so does the child.
void guard_what_follows(const Guarding& guarding, int kept);

// For a program that starts others and would only print that a signal ended one of them: starts a
// command, waits, and gives its exit status, or 128 + n after signal n.
int status_of(char** command);

}  // namespace bounce::box
