// What ./check says of a run: the parts with their points, the first thing to do, hints, and what
// tells more of a program than its checks.
#pragma once

#include "run.hpp"

namespace bounce::check {

// Whether there is nothing to mend: all checks pass, and where those of all parts do, sanitizers
// find nothing.
bool report(const Run& run);

// Under the first thing to do, where that is an error of the compiler.
void print_what_does_not_compile(const Run& run);

// Opens the hint for the first check that fails, a stage at a time.
void hint(const Run& run);

// The stage after the last one that was opened under this name; build/check/hint remembers it.
int next_stage(const std::string& name);
inline constexpr int kStages = 3;

// Writes the score record of the public checks, as ./kit grade --public --json does. Throws
// Failure.
void write_record(const Run& run, const std::string& file);

// Measures the program, writes study.html, and prints the verdict: the first time, and where it is
// asked for. Else says when that was done. Throws Failure if the program doesn't get to its end, or
// gives other numbers when it is optimised.
void study(const Run& run, bool is_asked);

// Asks part 2 about measured impacts, says how far it is off, and writes real.html. Throws Failure
// as study does.
void ask_about_real_impacts(Run& run);

// Says which buggy programs the cases in examples.txt catch, of one part or of all (0), or opens
// the next stage of a hint. Whether nothing is left to do. Throws Failure.
bool judge_examples(int part, bool hints);

// In bold with an empty line above it, and in a pale colour, as far as the terminal has these.
std::string heading(const std::string& text);
std::string dim(const std::string& text);

}  // namespace bounce::check
