// The submission is linked into the test program.
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "../submission.hpp"
#include "linked.hpp"

namespace bounce::tests {

using frames::Frame;

template <auto* function>
static void call(const Frame& question, Frame& answer, Trajectory* columns) {
  auto result = frames::answer(question, answer, linked<function>);
  if constexpr (std::is_same_v<decltype(result), Trajectory>) *columns = std::move(result);
}

// Turns any exception of the function into std::runtime_error, which says that it comes from the
// student's program.
Frame Linked::ask(const Frame& question, Trajectory* columns) {
  Frame answer;
  try {
#define BOUNCE_CALL(number, function) \
  if (question.part == number) call<&bounce::function>(question, answer, columns);
    BOUNCE_FUNCTIONS(BOUNCE_CALL)
  } catch (const std::exception& thrown) {
    throw std::runtime_error(submission::threw(question.part, thrown.what()));
  } catch (const char* text) {
    throw std::runtime_error(submission::threw(question.part, text));
  } catch (const std::string& text) {
    throw std::runtime_error(submission::threw(question.part, text));
  } catch (...) {
    throw std::runtime_error(submission::threw(question.part, ""));
  }
  if (columns == nullptr) return answer;
  const Eigen::Index size =
      submission::columns_at_hand(answer.q_columns, answer.v_columns, static_cast<int>(question.T));
  columns->q.conservativeResize(3, size);
  columns->v.conservativeResize(3, size);
  return answer;
}

}  // namespace bounce::tests
