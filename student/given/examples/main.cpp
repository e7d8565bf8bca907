// What ./check --examples and the course's grading start:
//   examples - TABLE                        judges the cases on standard input, as JSON
//   examples CASES TABLE PART               in words, of a part or of all (0)
//   examples CASES TABLE PART HINTS STAGE   the next hint, which the file STAGE remembers
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "judge.hpp"

namespace bounce::examples {
namespace {

constexpr int kStages = 3;

std::string read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(file == "-" ? std::cin : stream), {}};
}

std::string listed(const std::vector<std::string>& names, const std::string& quote = "") {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += ", ";
    text.append(quote).append(name).append(quote);
  }
  return text;
}

// Nothing in it is a student's text, and no sentence has a quotation mark.
void print_json(const Judged& judged) {
  std::cout << R"({"cases": [)";
  const char* comma = "";
  for (const Verdict& verdict : judged.verdicts) {
    std::cout << comma << R"({"place": ")" << verdict.place << R"(", "part": )" << verdict.part
              << R"(, "right": )" << (verdict.is_right ? "true" : "false") << R"(, "caught": [)"
              << listed(verdict.caught, "\"") << R"(], "message": ")" << verdict.sentence << "\"}";
    comma = ", ";
  }
  std::cout << R"(], "caught": [)" << listed(judged.caught, "\"") << R"(], "missed": [)"
            << listed(judged.missed, "\"") << "]}\n";
}

// Those of a part, or of all (0).
std::vector<std::string> of_part(const std::vector<std::string>& names, int part) {
  std::vector<std::string> chosen;
  for (const std::string& name : names) {
    if (!part || name[0] == '0' + part) chosen.push_back(name);
  }
  return chosen;
}

// Whether nothing is left to do.
bool report(const Judged& judged, int only) {
  bool is_done = true;
  for (const Verdict& verdict : judged.verdicts) {
    if (only && verdict.part && verdict.part != only) continue;
    const std::string caught = verdict.caught.empty() ? "no wrong program" : listed(verdict.caught);
    std::cout << "  " << verdict.place;
    if (verdict.part) std::cout << ", part " << verdict.part << (verdict.is_right ? "" : ": wrong");
    std::cout << ": " << (verdict.is_right ? "right; it catches " + caught : verdict.sentence)
              << '\n';
    is_done = is_done && verdict.is_right;
  }
  for (int part = 1; part <= 3; ++part) {
    if (only && part != only) continue;
    const auto caught = of_part(judged.caught, part), missed = of_part(judged.missed, part);
    std::cout << "Part " << part << ": your cases catch " << caught.size() << " of "
              << caught.size() + missed.size() << " wrong programs.";
    if (!missed.empty()) std::cout << " Not yet: " << listed(missed) << ".";
    std::cout << '\n';
    is_done = is_done && missed.empty();
  }
  if (!of_part(judged.missed, only).empty()) {
    std::cout << "A hint for the first of these: ./check "
              << (only ? std::to_string(only) + " " : "") << "--examples --hint\n";
  }
  return is_done;
}

// The next stage for the first wrong program that is left.
void hint(const std::vector<std::string>& missed, const std::string& hints,
          const std::string& memory) {
  if (missed.empty()) {
    std::cout << "Your cases catch all wrong programs: no hint is needed.\n";
    return;
  }
  const std::string& program = missed.front();
  const std::string last = read(memory), mark = "\n" + program + "\n";
  const int seen = last.rfind(program, 0) == 0 ? std::atoi(last.c_str() + program.size()) : 0;
  const int stage = std::min(seen + 1, kStages);
  std::ofstream(memory) << program << ' ' << stage;
  const std::string text = read(hints);
  std::size_t at = text.find(mark) + mark.size();
  for (int n = 1; n < stage; ++n) at = text.find('\n', at) + 1;
  std::cout << "Wrong program " << program << ", hint " << stage << " of " << kStages << ": "
            << text.substr(at, text.find('\n', at) - at) << '\n';
}

}  // namespace
}  // namespace bounce::examples

int main(int argc, char** argv) {
  using namespace bounce::examples;
  if (argc != 3 && argc != 4 && argc != 6) return 2;
  const Judged judged = judge(read(argv[1]), Table(read(argv[2])));
  if (argc == 3) {
    print_json(judged);
    return 0;
  }
  const int part = std::atoi(argv[3]);
  if (argc == 4) return report(judged, part) ? 0 : 1;
  hint(of_part(judged.missed, part), argv[4], argv[5]);
  return 1;
}
