// Given: the words of charts of error over time. The course's own charts have the same, and read
// them here.
#pragma once

namespace bounce::study {

constexpr const char* kErrorOverTime = "Error over time";
constexpr const char* kTime = "time of a simulated second";
constexpr const char* kError = "error";
constexpr const char* kYours = "yours";
constexpr const char* kAssignment = "assignment's scheme, as the course solves it";

}  // namespace bounce::study
