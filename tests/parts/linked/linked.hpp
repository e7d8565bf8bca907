// The functions under test that are linked into a student's own test program. A program has those
// of one part, and of no other.
#pragma once

#include <string>

#include "../submission.hpp"

namespace bounce::tests {

// A part's function where it is linked in, else null: linked<&bounce::step>.
template <auto* function>
inline decltype(function) linked = nullptr;

// Calls the functions that are linked in.
struct Linked : submission::Asker {
  frames::Frame ask(const frames::Frame& question, Trajectory* columns) override;
  // given.cpp
  frames::Frame right_answer(const frames::Frame& question) override;
  bool was_undecided() override;
};

// An earlier part's answer, of those that are recorded in given.json. Throws what isn't.
frames::Frame recorded_answer(frames::Frame asked);

// "134": the numbers of the parts that are linked in.
inline std::string linked_parts;

}  // namespace bounce::tests
