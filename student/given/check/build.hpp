// Builds what has changed, and says what is wrong where that fails.
#pragma once

#include <functional>

#include "parts.hpp"

namespace bounce::check {

#ifdef _WIN32
inline constexpr bool kHasSanitizers = false;
#else
inline constexpr bool kHasSanitizers = true;
#endif

// Builds every chosen part whose file compiles, with the earlier parts that it calls. Fills in
// run.unbuilt, and writes the first error of each file that doesn't compile to a file. Throws
// Failure if CMake itself fails.
void build_parts(Run& run);

// Builds these parts by themselves, with right answers for the earlier ones. Returns those that
// could be built.
std::vector<const Part*> build_given(const Run& run, const std::vector<const Part*>& parts);

// Builds a program for a page: study, real, or the checks of the optimised parts. Returns whether
// it could be built.
bool build_program(const std::string& name);

// The first error in a part's file, indented: file and line, and two lines more.
std::string first_error_of(int part);

// The compiler's warnings about the student's own files, one a line, sorted by file and line. Those
// about files that haven't changed are kept from earlier builds.
std::vector<std::string> warnings();

// A text that changes whenever a file in src/ or include/ does.
std::string state_of_sources();

// What `find` gives, which is remembered under the name until a source changes, unless it isn't
// `still_there`.
std::string once_after_a_change(const std::string& name, bool still_there,
                                const std::function<std::string()>& find);

}  // namespace bounce::check
