// Starts what tells more of a program than its checks: what it is worth, what it makes of measured
// impacts, and which wrong programs the student's cases catch.
#pragma once

#include "parts.hpp"

namespace bounce::check {

// Measures the program, writes study.html, and prints the verdict; where nothing changed since, it
// is only printed, and only if it is wanted `whole`. Throws Failure if the program doesn't get to
// its end, or gives other numbers when it is optimised.
void study(const Run& run, bool whole);

// Asks part 2 about measured impacts, says how far it is off, and writes real.html. Throws Failure
// as study does.
void ask_about_real_impacts(const Run& run);

// Says which wrong programs the cases in examples.txt catch, of one part or of all (0), or gives a
// hint. Whether nothing is left to do. Throws Failure.
bool judge_examples(int part, bool hints);

}  // namespace bounce::check
