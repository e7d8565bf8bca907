// Reports where and why a program crashes, in two lines before a signal ends it. The grader turns
// them into a message, and into the submission's file and line; so does ./check.
#pragma once

namespace bounce::runner {

inline constexpr char kCause[] = "cause of the crash: ";  // followed by one of these
inline constexpr char kNull[] = "null pointer";           // an address near 0
inline constexpr char kFullStack[] = "full stack";        // an address below the stack
inline constexpr char kCall[] = "system call ";           // and the call's number
inline constexpr char kDivision[] = "integer division";   // by zero
inline constexpr char kFloat[] = "floating point";        // an exception that the program enabled
inline constexpr char kFound[] = "found: ";               // and the sanitizers' name for it
inline constexpr char kUnknown[] = "unknown";             // anything else
inline constexpr char kStack[] = "stack of the crash:";   // and the addresses on the stack:
inline constexpr int kFrames = 150;                       // at most so many,
inline constexpr int kDigits = 16;                        // each " 0x" and so many digits

// From here on; to a file, or to standard error. Does nothing on Windows.
void report_crashes(const char* file = nullptr);

// Sets the cause of the next crash; `what` must stay valid.
void note_finding(const char* what);

}  // namespace bounce::runner
