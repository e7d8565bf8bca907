// Finds the `auto` that keeps an expression of Eigen too long; for ./check and the course's grading
// alike.
#pragma once

#include <string>

namespace bounce::check {

// What is said where `auto` is why a value is used that is gone.
inline constexpr char kAutoKeeps[] =
    "`auto` keeps an expression of Eigen that refers to a value which is gone by the next line; "
    "write `Eigen::Matrix3d`, or the type that it has";

// The line, from 1 on, of the `auto` in a source file that keeps what the statement at `line` uses
// when it is gone; `line` itself where several may; 0 where none does.
int line_of_auto(const std::string& text, int line);

}  // namespace bounce::check
