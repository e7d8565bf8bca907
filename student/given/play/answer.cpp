// Answers a question of the page of --play: calls the four parts in a process of its own, so that a
// crash ends nothing else.
//
//   answer FOLDER
//
// In the folder it reads question.json and writes answer.json; and where it crashes, stack.txt.
#include <fstream>

#include "../drawing.hpp"
#include "../study/tables.hpp"
#include "crash.hpp"
#include "linked/time_limit.hpp"

namespace bounce::play {
namespace {

using nlohmann::json;

constexpr int kMostColumns = 100'000;

// The motion as the page draws it, or what there is to say in its place.
std::string answer(std::ifstream question) {
  try {
    const json asked = json::parse(question);
    const Parameters params = study::parameters_of(asked.at("params"));
    if (params.T < 1 || params.T > kMostColumns)
      throw std::invalid_argument("these are too many steps: choose a larger dt");
    return data_of({simulated(study::state_of(asked), params), params}).dump();
  } catch (const json::exception&) {
    return json{{"problem", "this question isn't understood"}}.dump();
  } catch (const std::exception& error) {
    return json{{"problem", error.what()}}.dump();
  }
}

}  // namespace
}  // namespace bounce::play

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  bounce::runner::report_crashes((folder / "stack.txt").string().c_str());
  bounce::tests::limit_time([] {});
  const std::string answer = bounce::play::answer(std::ifstream(folder / "question.json"));
  bounce::tests::lift_time_limit();
  std::ofstream(folder / "answer.json") << answer;
  return 0;
}
