// Says what compilers, linkers and sanitizers print, and why a program with a student's parts
// ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

// The first error with the file and line that it comes from, indented, and two lines more. Where it
// is inside of a library, with the student's own line that asked for it.
std::string first_error(const std::vector<std::string>& lines);

// Whether all files compiled, and the linker missed a function, or found it twice.
bool is_linker_error(const std::vector<std::string>& lines);

// What the first error usually means, in a sentence; empty where that isn't known.
std::string meaning_of(const std::vector<std::string>& lines);

// ---- how a program ends ----

inline constexpr int kTooLong = 124;  // its exit code where an answer takes too long

// "src/part3_step.cpp:12: it uses a variable that is gone"; empty if sanitizers found nothing.
std::string found_by_sanitizers(const std::string& printed);

// "the program crashed: a division by zero", from how it ended and all that it printed.
std::string reason_of(const Termination& ended, const std::string& printed);

// ", at src/part4_simulate.cpp:10": the innermost of the addresses in the file that is the
// student's. Empty where that can't be had, as on Windows.
std::string place_of_crash(const std::string& program, const std::filesystem::path& stack);

}  // namespace bounce::check
