// Says what compilers, linkers and sanitizers print, and why a program with a student's parts
// ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ending.hpp"
#include "process.hpp"

namespace bounce::check {

// ---- what a build prints ----

// The lines, with files of this folder named from it ("src/part1_contacts.cpp"), and errors of
// Visual C++ written as the others do: "file:12: error: what".
std::vector<std::string> own_lines(const std::string& printed);

bool is_warning_of_own_file(const std::string& line);

// Of "src/helper.hpp:12:3: warning: what".
std::string file_of(const std::string& line);
int line_of(const std::string& line);

struct BuildError {
  std::string text;           // indented
  std::string sentence{};     // the same in one line, without the lines that the compiler quotes
  std::string place{};        // "src/part3_step.cpp:12:3", if known
  bool is_of_linker = false;  // all files compiled, and a function is missing, or there twice
};

// The first error with the file and line that it comes from, two lines more, and what it usually
// means, where that is known. Where it is inside of a library, with the student's own line that
// asked for it.
BuildError first_error(const std::vector<std::string>& lines);

// ---- how a program ends ----

// Its exit code where an answer takes too long, and where it waits for a minute.
inline constexpr int kTooLong = 124, kWaited = 125;

// "src/part3_step.cpp:12: it uses a variable that is gone"; empty if sanitizers found nothing.
std::string found_by_sanitizers(const std::string& printed);

// Why it crashed, as grader/runner/crash.hpp names it in this file: "null pointer".
std::string cause_in(const std::filesystem::path& stack);

// How it ended, from what `run` returned and all that it printed.
words::Ending ending_of(int ended, const std::string& printed,
                        const std::string& cause = "unknown");

// The same in words; or what sanitizers found.
std::string reason_of(int ended, const std::string& printed, const std::string& cause = "unknown");

// "src/part4_simulate.cpp:10": the innermost of the addresses in the file that is the student's.
// Empty where that can't be had, as on Windows.
std::string place_of_crash(const std::string& program, const std::filesystem::path& stack);

}  // namespace bounce::check
