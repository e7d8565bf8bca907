#include "answers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "checks.hpp"

namespace bounce::tests {
namespace {

constexpr int kShort = 40;  // columns; of a shorter trajectory, the last column is compared

std::map<int, AskNumbers>& functions() {
  static std::map<int, AskNumbers> by_part;
  return by_part;
}

Answer answer(submission::Asker& asker, AskNumbers ask, const Case& c) {
  try {
    return {ask(asker, c), ""};
  } catch (const std::exception& thrown) {
    return {{}, thrown.what()};
  }
}

}  // namespace

// The last one of a long trajectory stands in a sentence of tables.txt, too.
std::vector<int> known_columns(int T) {
  std::vector<int> columns{0, 1, 2, 3, 5, 8, 13, 21, 34};
  columns.erase(std::lower_bound(columns.begin(), columns.end(), T), columns.end());
  if (T <= kShort && columns.back() != T - 1) columns.push_back(T - 1);
  return columns;
}

Eigen::VectorXd numbers_of(const State& next, const Case& c) {
  Eigen::VectorXd numbers(6);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double move = next.q(i) - c.q(i) - c.params.dt * next.v(i);
    const double rounding = 1e-14 * (1 + std::abs(next.q(i)) + std::abs(c.q(i)));
    numbers(i) = std::abs(move) < rounding ? 0 : move;
    numbers(3 + i) = next.v(i);
  }
  return numbers;
}

Eigen::VectorXd numbers_of(const Trajectory& trajectory) {
  const std::vector<int> columns = known_columns(static_cast<int>(trajectory.q.cols()));
  Eigen::VectorXd numbers(6 * static_cast<Eigen::Index>(columns.size()));
  double* next = numbers.data();
  for (const int column : columns) {
    for (const Eigen::Matrix3Xd* states : {&trajectory.q, &trajectory.v}) {
      for (Eigen::Index i = 0; i < 3; ++i) *next++ = (*states)(i, column);
    }
  }
  return numbers;
}

int numbers_together(int part) { return part == 1 ? 7 : part == 2 ? 20 : 6; }

std::filesystem::path public_file(int part, const std::string& folder) {
  const std::string beginning = "part" + std::to_string(part);
  for (const auto& fixtures : fixture_folders) {
    if (fixtures.filename() == "hidden" || !is_directory(fixtures / folder)) continue;
    for (const auto& file : std::filesystem::directory_iterator(fixtures / folder)) {
      if (file.path().filename().string().rfind(beginning, 0) == 0) return file.path();
    }
  }
  throw std::runtime_error("there are no public fixtures of part " + std::to_string(part));
}

bool register_call(int part, AskNumbers ask) {
  functions()[part] = ask;
  return true;
}

std::vector<Answer> answers(submission::Asker& asker, int part,
                            const std::vector<Case>& questions) {
  std::vector<Answer> all;
  try {
    for (const Case& c : questions) all.push_back(answer(asker, functions().at(part), c));
  } catch (const Ended&) {
    return {};
  }
  return all;
}

}  // namespace bounce::tests
