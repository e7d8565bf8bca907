// Where and why a program crashed, as two lines on standard error, which are written before a
// signal ends it. The grader turns them into words, and into the submission's file and line.
#pragma once

namespace bounce::runner {

inline constexpr char kCause[] = "cause of the crash: ";  // and one of these
inline constexpr char kNull[] = "null pointer";           // an address near 0
inline constexpr char kFullStack[] = "full stack";        // an address where it should grow to
inline constexpr char kCall[] = "system call ";           // and its number
inline constexpr char kDivision[] = "integer division";   // by zero
inline constexpr char kFloat[] = "floating point";        // an exception that was asked for
inline constexpr char kFound[] = "found: ";               // and what the sanitizers call it
inline constexpr char kUnknown[] = "unknown";             // anything else
inline constexpr char kStack[] = "stack of the crash:";   // and the addresses on it

// What the next crash is because of; `what` stays where it is.
void note_finding(const char* what);

}  // namespace bounce::runner
