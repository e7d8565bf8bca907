// Asks your form_lcp about measured impacts, and writes a page with how far it is off.
//
//   real MEASURED PAGE [--wrong]
//
// ./check --real builds and starts it. --wrong: checks of part 2 fail, and the page says so.
#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <string>

#include "../study/chart.hpp"
#include "../study/numbers.hpp"
#include "../study/page.hpp"
#include "sentence.hpp"

namespace bounce::real {
namespace {

constexpr double kBeyond = 3;  // times the largest error of a law: longer bars are cut

std::string chart(const Measured& measured, const Result& mine, bool is_wrong) {
  const auto bar = [](const std::string& name, double error, bool is_own = false) {
    return study::Bar{name, speed(error), error, is_own};
  };
  std::vector<study::Bar> bars{bar("your form_lcp", mine.error, true),
                               bar(measured.assignment.name, measured.assignment.error)};
  double most = measured.assignment.error;
  for (const Law& law : measured.others) {
    bars.push_back(bar(law.name, law.error));
    most = std::max(most, law.error);
  }
  bars.push_back(bar("the least that any push at the corner leaves", measured.floor));
  most = std::isfinite(mine.error) ? std::max(most, std::min(mine.error, kBeyond * most)) : most;
  return study::bars("How far the velocity after an impact is off, in the median", bars, most,
                     sentence(measured, mine, is_wrong));
}

std::string page(const Measured& measured, bool is_wrong) {
  const Parameters& p = measured.params;
  return study::page(
      "Your form_lcp on real impacts",
      is_wrong ? "Checks of part 2 fail. The chart shows your form_lcp as it is; mend what ./check "
                 "names first, then look at this."
               : "",
      "<p>A real square of " + study::length(p.l) +
          " was dropped again and again, and filmed at 250 pictures a second. For each impact of "
          "one corner the film gives the velocity just before and just after. Your form_lcp gets "
          "the velocity before, with mu = " +
          study::number(p.mu, "%.2g") + " and epsilon = " + study::number(p.epsilon, "%.2g") +
          ", which fit other impacts of this square best, and without gravity, as an impact takes "
          "next to no time. The forces that solve_lcp finds then give a velocity after the "
          "impact.</p>\n<p>How far that is from the measured one is the error; omega counts times "
          "the square's radius of gyration, " +
          study::length(p.l / std::sqrt(6.0)) +
          ". Half of the impacts are off by less than the median, half by more.</p>\n" +
          chart(measured, ask(measured), is_wrong) +
          "<p>The impacts were measured by N. Fazeli and colleagues (MCube Lab, MIT) and published "
          "in DAIRLab/ImpactModeling; their licence is in fixtures/measured.txt. Question 5 "
          "of <a href=\"explore.html\">Explore</a> asks what this shows.</p>\n");
}

}  // namespace
}  // namespace bounce::real

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: real MEASURED PAGE [--wrong]; ./check --real starts it\n";
    return 2;
  }
  try {
    bounce::study::write_page(argv[2],
                              bounce::real::page(bounce::real::read_measured(argv[1]), argc > 3));
  } catch (const std::exception& error) {
    std::cerr << "No page was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
