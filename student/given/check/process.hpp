// Starts another program and waits until it ends; in process_posix.cpp and process_windows.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bounce::check {

// How a program ended: with an exit code, or by a signal. On Windows, an exception has the signal's
// number that it would have elsewhere.
struct Termination {
  int code = 0;
  int signal = 0;
};

enum class Limits { none, of_a_part };  // of a part: memory, time, the size of what it prints

// Runs the command, with nothing to read. What it prints is added to `output`. Empty if the program
// can't be started.
std::optional<Termination> run(const std::vector<std::string>& command,
                               const std::filesystem::path& output, Limits limits);

// Held by one check at a time in this folder; the system takes it back however the program ends.
class Lock {
 public:
  // If another check holds the lock, prints a message and waits. Throws Failure.
  explicit Lock(const std::filesystem::path& file);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
#ifdef _WIN32
  void* handle_;
#else
  int handle_;
#endif
};

// Whether standard output is a terminal.
bool is_terminal();

}  // namespace bounce::check
