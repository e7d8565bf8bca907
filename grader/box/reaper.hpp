// The guard of a box: our own process, which stays unrestricted while its child runs the command.
// It waits for the child, counts its CPU time, kills what it leaves behind, and passes out the file
// that it has made.
#pragma once

#include <sys/types.h>

#include <vector>

namespace bounce::box {

struct Guarding {
  void (*before)();      // called in the guard before the child goes on: its filter, or nothing
  void (*afterwards)();  // called in the guard once the child and all its processes are gone
};

// Forks, and returns in the child once the guard is ready. The guard ends when the child does, with
// its exit status, or 128 + n after signal n. It keeps the descriptors `kept` and no others.
// If the process that started this one ends, so does the child.
void guard_what_follows(const Guarding& guarding, std::vector<int> kept);

// Starts a command, waits, and returns its exit status, or 128 + n after signal n; a status of 1
// becomes 3. For the programs that g++ starts: g++ passes these statuses on, and exits with 1
// itself only if it couldn't start a program.
int status_of(char** command);

}  // namespace bounce::box
