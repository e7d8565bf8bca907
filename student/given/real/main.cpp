// Asks your form_lcp about measured impacts, and writes a page with how far it is off.
//
//   real MEASURED PAGE [--wrong]
//
// ./check --real builds and starts it. --wrong: checks of part 2 fail, and the page says so.
#include <exception>
#include <iostream>
#include <string>

#include "../study/chart.hpp"
#include "../study/numbers.hpp"
#include "pages.hpp"
#include "sentence.hpp"

namespace bounce::real {
namespace {

using study::list, study::number_or_null, study::quoted;

std::string numbers(const Vector3& v) { return list(v, number_or_null); }

std::string bar(const std::string& name, double error, bool is_own = false) {
  return R"({"name":)" + quoted(name) + R"(,"error":)" + number_or_null(error) + R"(,"label":)" +
         quoted(speed(error)) + R"(,"own":)" + (is_own ? "true" : "false") + "}";
}

std::string bars(const Measured& measured, const Result& mine) {
  std::string text = "[" + bar("your form_lcp", mine.error, true) + ",\n" +
                     bar(measured.assignment.name, measured.assignment.error);
  for (const Law& law : measured.others) text += ",\n" + bar(law.name, law.error);
  return text + ",\n" + bar("the least that any push at the corner leaves", measured.floor) + "]";
}

std::string impacts(const Measured& measured, const Result& mine) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < measured.impacts.size(); ++i) {
    const Impact& hit = measured.impacts[i];
    const Answer& answer = mine.answers[i];
    all.push_back(R"({"r":[)" + number_or_null(hit.r_x) + "," + number_or_null(hit.r_y) +
                  R"(],"before":)" + numbers(hit.before) + R"(,"after":)" + numbers(hit.after) +
                  R"(,"mine":)" + numbers(answer.after) + R"(,"error":)" +
                  number_or_null(answer.error) + "}");
  }
  return list(all, [](const std::string& impact) { return impact; });
}

std::string data(const Measured& measured, bool is_wrong) {
  const Result mine = ask(measured);
  const Parameters& p = measured.params;
  return R"({"wrong":)" + std::string(is_wrong ? "true" : "false") + R"(,"l":)" +
         number_or_null(p.l) + R"(,"mu":)" + quoted(study::number(p.mu, "%.2g")) +
         R"(,"epsilon":)" + quoted(study::number(p.epsilon, "%.2g")) + R"(,"sentence":)" +
         quoted(sentence(measured, mine, is_wrong)) + ",\n\"bars\":" + bars(measured, mine) +
         ",\n\"impacts\":" + impacts(measured, mine) + "}";
}

}  // namespace
}  // namespace bounce::real

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: real MEASURED PAGE [--wrong]; ./check --real starts it\n";
    return 2;
  }
  try {
    const auto measured = bounce::real::read_measured(argv[1]);
    bounce::study::write_page(argv[2], bounce::pages::impacts,
                              bounce::real::data(measured, argc > 3));
  } catch (const std::exception& error) {
    std::cerr << "No page was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
