// Fuzzes the reader of fixtures: it returns complete cases, or refuses the file.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../../parts/cases.hpp"
#include "fuzz.hpp"

namespace bounce {

std::vector<std::filesystem::path> tests::fixture_folders() { return {BOUNCE_FIXTURES}; }
void tests::about_to_ask(const Case&) {}
void tests::found_wrong(const Case&, const Problem&) {}
std::string tests::in_words(const Failure&) { return ""; }

namespace fuzz {

// Each check of the public fixtures by itself, with its first case.
std::vector<std::string> seeds() {
  std::vector<std::string> all;
  for (const char* stem : {"part1_contacts", "part2_lcp", "part3_step", "part4_simulate"}) {
    std::ifstream in(std::string(BOUNCE_FIXTURES) + "/" + stem + ".json");
    const nlohmann::json whole = nlohmann::json::parse(in);
    for (const auto& [check, cases] : whole.at("checks").items()) {
      all.push_back(nlohmann::json{{"checks", {{check, {cases.at(0)}}}}}.dump());
    }
  }
  return all;
}

namespace {

void require_whole(const tests::Case& c) {
  require(c.params.T >= 1);
  require(c.trajectory.q.cols() == static_cast<Eigen::Index>(c.columns.size()));
  require(c.trajectory.v.cols() == c.trajectory.q.cols());
  for (const int column : c.columns) require(column >= 0 && column < c.params.T);
  const bool finite = c.q.allFinite() && c.v.allFinite() && c.J.allFinite() &&
                      c.contact.J.allFinite() && c.lcp.V.allFinite() && c.lcp.p.allFinite() &&
                      c.state.q.allFinite() && c.trajectory.q.allFinite();
  require(finite && std::isfinite(c.tolerance));
}

}  // namespace
}  // namespace fuzz
}  // namespace bounce

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
  try {
    for (const auto& c : bounce::tests::read_cases(file, false)) bounce::fuzz::require_whole(c);
  } catch (const std::exception& refused) {
    bounce::fuzz::require(refused.what()[0] != '\0');
  }
  return 0;
}
