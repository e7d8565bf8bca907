// Starts another program and waits until it ends; in process_posix.cpp and process_windows.cpp.
#pragma once

#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bounce::check {

#ifdef _WIN32
enum : int { SIGBUS = 901, SIGKILL, SIGXCPU, SIGXFSZ };  // which nothing ends with
inline constexpr bool kHasSanitizers = false;
#else
inline constexpr bool kHasSanitizers = true;
#endif

inline const std::filesystem::path kWork = "build/check";  // what the check keeps between runs

// Of a part, where a system has such limits.
inline constexpr int kLargestFile = 10'240'000;  // bytes that it may print
inline constexpr int kSecondsOfWork = 30;        // each check ends sooner, a constructor may not

enum class Limits { none, of_a_part };  // of a part: memory, time, the size of what it prints

// Runs the command, with nothing to read. What it prints is added to `output`. Returns its exit
// code, or the negative number of the signal that ended it; on Windows, an exception has the number
// that it would have elsewhere. Empty if the program can't be started.
std::optional<int> run(const std::vector<std::string>& command, const std::filesystem::path& output,
                       Limits limits);

// Held by one check at a time in this folder, until the result is gone or the program ends, however
// it does. If another check holds it, prints a message and waits. Throws Failure.
std::shared_ptr<void> lock(const std::filesystem::path& file);
inline constexpr const char* kWaits =
    "check: another check is running in this folder; this one waits for it";
inline constexpr const char* kReadOnly =
    "the folder build/ can't be written here: move the handout to your own files";

// Whether standard output is a terminal.
bool is_terminal();

}  // namespace bounce::check
