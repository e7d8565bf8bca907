// What the per-part tests share: the cases of a check, read from the fixtures, and a comparison
// of what came with what was expected.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounce::tests {

// One question and its right answer. Only the members of the case's own part are filled in.
struct Case {
  std::string name;
  bool hidden = false;   // the expected answer is not shown
  double tolerance = 0;  // on each entry, absolute or relative, whichever is wider
  Parameters params;
  std::string input;                                          // the question in words, with units
  std::string corner;                                         // what the corner does, in words
  Vector3 q = Vector3::Zero(), v = Vector3::Zero();           // parts 1 to 3; q_0 and v_0 in part 4
  Jacobian J = Jacobian::Zero();                              // part 2
  Contact contact{Jacobian::Zero(), 0};                       // expected, part 1
  Lcp lcp{Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};  // expected, part 2
  State state{Vector3::Zero(), Vector3::Zero()};              // expected, part 3
  std::vector<int> columns;                                   // part 4: which columns are known
  Trajectory trajectory;                                      // expected, part 4, these columns
};

// A quantity that came out wrong.
struct Difference {
  std::string name, unit;
  Eigen::MatrixXd expected, got;
};

// What is wrong with an answer; nothing where it is empty.
struct Problem {
  std::string sentence;  // what numbers alone don't say
  std::vector<Difference> differences;
  Eigen::Matrix3Xd path;  // part 4: the q that came
  int column = -1;        // part 4: the first wrong one, where one is
  bool empty() const { return sentence.empty() && differences.empty(); }
};

constexpr const char* kConfiguration = "m, m, rad";
constexpr const char* kVelocity = "m/s, m/s, rad/s";

// --- defined by the program that runs the tests ---

// Where fixtures are read from. A folder named "hidden" holds hidden cases.
std::vector<std::filesystem::path> fixture_folders();

// The cases of a check in one file of fixtures. Throws std::exception where it isn't one.
std::vector<Case> read_cases(std::istream& file, const std::string& check, bool hidden);

// Those of all checks of a public file, in its order.
std::vector<Case> read_all_cases(std::istream& file);

// Called before each question.
void about_to_ask(const Case& c);

// The problem as its reader is told it: summary, or more for a student at work.
std::string in_words(const Case& c, const Problem& problem);

// --- for the tests ---

// Asks every case of the running check, public ones first. `ask` returns what is wrong; the first
// wrong case is reported, with the number of those that are wrong. An exception is a wrong answer
// too; after one that ended the program, the check is over.
void for_each_case(const std::function<Problem(const Case&)>& ask);

// Thrown by a submission that can answer no more questions of this check.
struct Ended : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Empty when got agrees with expected in every entry. NaN never agrees.
Problem compare(const Case& c, const std::string& name, const std::string& unit,
                const Eigen::MatrixXd& expected, const Eigen::MatrixXd& got);
Problem compare(const Case& c, const std::string& name, const std::string& unit, double expected,
                double got);

// Whether each entry is right.
Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> agrees(const Case& c,
                                                          const Eigen::MatrixXd& expected,
                                                          const Eigen::MatrixXd& got);

// The differences of both.
Problem both(const Problem& a, const Problem& b);

// What is wrong in a few lines: what was expected, unless the case is hidden, and what came, with
// the wrong entries in brackets.
std::string summary(const Case& c, const Problem& problem);

// The largest error that compare has met so far in public cases, in units of max(1, |expected|).
// That of a hidden case would tell what is expected to whoever knows the answer.
double largest_error();

}  // namespace bounce::tests
