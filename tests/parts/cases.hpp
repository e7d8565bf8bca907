// The cases of the checks: reads them from the fixtures, and compares answers with the expected
// ones.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace bounce::tests {

// One question and its right answer. Only the members of the case's own part are filled in.
struct Case {
  std::string check, name;
  bool hidden = false;   // the expected answer is not shown
  double tolerance = 0;  // on each entry, absolute or relative, whichever is larger
  Parameters params;
  std::string corner;                                // what the corner does, in words
  std::vector<std::string> input;                    // the names of what is asked: q, v, J
  Vector3 q = Vector3::Zero(), v = Vector3::Zero();  // parts 1 to 3; q_0 and v_0 in part 4
  Jacobian J = Jacobian::Zero();                     // part 2
  Contact contact{Jacobian::Zero(), 0};              // expected, part 1
  std::optional<Jacobian> other_J;                   // as right, where two corners are equally low
  Lcp lcp{Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};  // expected, part 2
  State state{Vector3::Zero(), Vector3::Zero()};              // expected, part 3
  std::vector<int> columns;                                   // part 4: the columns that are stored
  Trajectory trajectory;                                      // expected, part 4, these columns
  bool has_decidable_steps = false;  // those that follow, too: parts 3 and 4
};

// A wrong quantity.
struct Difference {
  std::string name, unit;
  Eigen::MatrixXd expected, got;
};

// What is wrong with an answer; empty if nothing is.
struct Problem {
  std::string sentence;  // what the numbers alone don't say
  std::vector<Difference> differences;
  bool is_open = false;  // right as far as recorded answers held what was asked
  bool empty() const { return sentence.empty() && differences.empty(); }
};

constexpr const char* kConfiguration = "m, m, rad";
constexpr const char* kVelocity = "m/s, m/s, rad/s";

// Set by the program that runs the tests: the folders of the fixtures. One named "hidden" holds
// hidden cases.
inline std::vector<std::filesystem::path> fixture_folders;

// --- reading ---

// The cases in one file of fixtures, in its order. Throws std::exception if the file is invalid.
std::vector<Case> read_cases(std::istream& file, bool hidden);

// The cases of a check in all fixtures. Those of "part3.FallsFreely" are in files whose stem begins
// with "part3".
std::vector<Case> cases_of(const std::string& check);

// --- comparing ---

// Empty if got agrees with expected in every entry. NaN never agrees.
Problem compare(const Case& c, const std::string& name, const std::string& unit,
                const Eigen::MatrixXd& expected, const Eigen::MatrixXd& got);
Problem compare(const Case& c, const std::string& name, const std::string& unit, double expected,
                double got);

// For each entry, whether it is right.
Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> agrees(const Case& c,
                                                          const Eigen::MatrixXd& expected,
                                                          const Eigen::MatrixXd& got);

// The differences of both.
Problem both(const Problem& a, const Problem& b);

// The largest error that compare has found so far in public cases, in units of max(1, |expected|).
// That of a hidden case would reveal the expected answer to whoever knows their own.
double largest_error();

}  // namespace bounce::tests
