#include "sentence.hpp"

#include <cmath>

#include "../study/numbers.hpp"

namespace bounce::real {
namespace {

constexpr double kSame = 1e-3;  // of the error: the table's numbers have five digits

std::string refused(const Result& mine, std::size_t all) {
  return "In " + std::to_string(mine.no_solution) + " of " + std::to_string(all) +
         " impacts solve_lcp finds no solution to your V and p";
}

// Beside the same law by the solution.
std::string compared(double mine, double right, bool is_wrong) {
  const bool is_same = std::abs(mine - right) <= kSame * right;
  const std::string with = "With the same mu and epsilon the assignment's law is " + speed(right);
  if (is_same && is_wrong)
    return "So is the assignment's law: what the checks find doesn't show in an impact, in which "
           "gravity plays no part.";
  if (is_same)
    return "So is the assignment's law: what is left is the error of the law, not of your program.";
  return mine > right ? with + " off: what is more comes from your program."
                      : with + " off: yours isn't that law, and being nearer is luck.";
}

}  // namespace

std::string speed(double metres_per_second) {
  if (!std::isfinite(metres_per_second)) return "no answer";
  return study::number(metres_per_second, "%.2g") + " m/s";
}

std::string sentence(const Measured& measured, const Result& mine, bool is_wrong) {
  const std::string unsolved = mine.no_solution ? refused(mine, measured.impacts.size()) : "";
  if (!std::isfinite(mine.error)) return unsolved + ", so that there is no median to compare.";
  std::string text = "Over " + std::to_string(measured.impacts.size()) +
                     " measured impacts the velocity that follows from your form_lcp is " +
                     speed(mine.error) + " off in the median. " +
                     compared(mine.error, measured.assignment.error, is_wrong);
  text += " Of simpler laws,";
  for (const Law& law : measured.others)
    text += (&law == &measured.others.front() ? " " : ", and ") + law.name + " is " +
            speed(law.error) + " off";
  text += "; no push at the corner, by whatever law, gets below " + speed(measured.floor) +
          ". The gap from " + speed(measured.assignment.error) +
          " to that is what a better law could gain.";
  return unsolved.empty() ? text : text + " " + unsolved + ".";
}

}  // namespace bounce::real
