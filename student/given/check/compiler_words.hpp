// What g++, clang, Visual C++ and sanitizers print.
#pragma once

#include <string>
#include <vector>

namespace bounce::check {

// The lines, with files of this folder named from it ("src/part1_contacts.cpp"), and errors of
// Visual C++ written as the others do: "file:12: error: what".
std::vector<std::string> own_lines(const std::string& printed);

bool is_warning_of_own_file(const std::string& line);

// Whether such a warning says that a function may end without returning anything.
bool is_missing_return(const std::string& line);

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

// What a failed assertion of Eigen or of the standard library means; empty where that isn't known.
std::string meaning_of_assertion(const std::string& line);

// "src/part4_simulate.cpp:10" of the first line that names a place in src/; empty if none does.
std::string place_in_sources(const std::vector<std::string>& lines);

// "src/part3_step.cpp:12: it uses a variable that is gone"; empty if they found nothing.
std::string found_by_sanitizers(const std::vector<std::string>& lines);

}  // namespace bounce::check
