// Says why a program with a student's parts ended.
#pragma once

#include <csignal>
#include <filesystem>
#include <string>

#include "process.hpp"

namespace bounce::check {

inline constexpr int kTooLong = 124;  // such a program's exit code where an answer takes too long
#ifdef SIGXFSZ
inline constexpr int kPrintedTooMuch = SIGXFSZ;
#else
inline constexpr int kPrintedTooMuch = -1;
#endif

// "the program crashed: a division by zero", from how it ended and all that it printed.
std::string reason_of(const Termination& ended, const std::string& printed);

// ", at src/part4_simulate.cpp:10": the innermost of the addresses in the file that is the
// student's. Empty where that can't be had, as on Windows.
std::string place_of_crash(const std::string& program, const std::filesystem::path& stack);

}  // namespace bounce::check
