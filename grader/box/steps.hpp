// The steps into a box that `enter` takes from inside.
#pragma once

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounce::box {

// Turns a failed system call into an exception with the reason. libseccomp returns -errno, whereas
// system calls return -1 and set errno.
template <class Result>
Result require(Result result, const std::string& what) {
  if (result >= 0) return result;
  const int why = result == -1 ? errno : -static_cast<int>(result);
  throw std::runtime_error(what + ": " + std::strerror(why));
}

// --- reaper.cpp: the guard of a box, our own process, which stays unrestricted while its child
// runs the command. It waits for the child, counts its CPU time, kills what it leaves behind, and
// passes out the file that it has made. ---

struct Guarding {
  void (*before)();      // called in the guard before the child goes on: its filter, or nothing
  void (*afterwards)();  // called in the guard once the child and all its processes are gone
};

// Forks, and returns in the child once the guard is ready. The guard ends when the child does, with
// its exit status, or 128 + n after signal n. It keeps the descriptors `kept` and no others.
// If the process that started this one ends, so does the child.
void guard_what_follows(const Guarding& guarding, const std::vector<int>& kept);

// Starts a command, waits, and returns its exit status, or 128 + n after signal n; a status of 1
// becomes 3. For the programs that g++ starts: g++ passes these statuses on, and exits with 1
// itself only if it couldn't start a program.
int status_of(char** command);

// --- landlock.cpp: access to the file system if there is no mount namespace ---

// From here on, this process and its children may read and execute files beneath `visible`, write
// beneath `writable` (if it isn't empty) and to /dev/null, and access no other file. If the kernel
// can forbid it, they also can't connect to anything or send signals out of the box. Throws
// std::runtime_error if the kernel has no Landlock.
void see_only(const std::vector<std::string>& visible, const std::string& writable);

// --- filter.cpp: the filters of system calls ---

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
