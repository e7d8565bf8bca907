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

// Starts a command, waits, and returns its exit status, 3 in place of 1, or 128 + n after signal n.
// For programs such as g++, which would only print that a signal ended a child, and exit with 1
// both where a child did and where none could be started.
int status_of(char** command);

}  // namespace bounce::box
