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
// run.unbuilt and run.errors. Throws Failure if CMake itself fails.
void build_parts(Run& run);

// Builds these parts by themselves, with right answers for the earlier ones. Returns those that
// could be built.
std::vector<const Part*> build_given(const Run& run, const std::vector<const Part*>& parts);

// Builds a program for a page: study, real, or the checks of the optimised parts. Returns whether
// it could be built.
bool build_program(const std::string& name);

// The compiler's warnings about the student's own files, one a line, sorted by file and line. Those
// about files that haven't changed are kept from earlier builds.
std::vector<std::string> warnings();

// A line for each file in src/ and include/: a digest of what it holds, and its name.
std::string state_of_sources();

// What `find` gives, which is remembered under the name until a source changes, unless it isn't
// `still_there`.
std::string once_after_a_change(const std::string& name, bool still_there,
                                const std::function<std::string()>& find);

}  // namespace bounce::check
