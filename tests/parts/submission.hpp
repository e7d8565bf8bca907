// The code under test. The tests ask it only by submission::get_contacts and so on, with an Asker
// and the arguments of the part's own function, whose result they return.
#pragma once

#include <stdexcept>
#include <type_traits>

#include "functions.hpp"
#include "messages.hpp"

namespace bounce::submission {

// Asks the code under test: linked/linked.hpp calls the functions directly (in a student's own
// build, where a debugger works); the judge's session.hpp asks a runner in another process.
struct Asker {
  virtual ~Asker() = default;

  // The answer to a question, and of part 4 the first T columns, or T - 1 if one is missing, so
  // that a wrong number of columns doesn't make the others wrong. Throws MissingColumns if q or v
  // has fewer, or none. Where part 4's checks ask for a step, the judge gives the right one.
  virtual frames::Frame ask(const frames::Frame& question, Trajectory* columns) = 0;

  // The right answer to a question about an earlier part: the solution's, or a recorded one. Throws
  // std::runtime_error where there is none.
  virtual frames::Frame right_answer(const frames::Frame& question) = 0;

  // Whether, since this was last called, recorded answers that stand for the earlier parts didn't
  // hold what was asked: an answer then decides nothing.
  virtual bool was_undecided() { return false; }
};

// "part 3, or what it calls, threw an exception: "oh"": it comes from the student's program.
// Without a text, what was thrown is no std::exception.
std::string threw(std::uint32_t part, const std::string& text);

struct MissingColumns : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws MissingColumns, naming the shapes, unless both numbers of columns are T.
void require_columns(Eigen::Index q_columns, Eigen::Index v_columns, int T);

// How many of the first T columns both have. Throws the same if more than one is missing.
Eigen::Index columns_at_hand(Eigen::Index q_columns, Eigen::Index v_columns, int T);

template <int part, auto* function>
struct Asked;

template <int part, class Result, class... Arguments, Result (*function)(Arguments...)>
struct Asked<part, function> {
  // Of part 4, throws MissingColumns unless q and v are both 3xT.
  Result operator()(Asker& asker, Arguments... arguments) const {
    const frames::Frame question = frames::question(part, arguments...);
    if constexpr (std::is_same_v<Result, Trajectory>) {
      Trajectory columns;
      const frames::Frame answer = asker.ask(question, &columns);
      require_columns(answer.q_columns, answer.v_columns, static_cast<int>(question.T));
      return columns;
    } else {
      return frames::result<Result>(asker.ask(question, nullptr));
    }
  }
};

#define BOUNCE_ASKED(number, function) inline constexpr Asked<number, &bounce::function> function{};
BOUNCE_FUNCTIONS(BOUNCE_ASKED)
#undef BOUNCE_ASKED

inline Trajectory first_columns(Asker& asker, const Vector3& q_0, const Vector3& v_0,
                                const Parameters& params) {
  Trajectory columns;
  asker.ask(frames::question(4, q_0, v_0, params), &columns);
  return columns;
}

}  // namespace bounce::submission
