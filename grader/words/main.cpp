// words FOLDER
//
// Says the judge's facts in the words of a report, with the sentences in FOLDER. Reads a JSON list
// of verdicts, {"ended": facts or null, "failure": facts or null, "place", "found"}, with the facts
// of grader/judge/facts.hpp and termination.hpp, the line where the program crashed, and what
// sanitizers found there, both perhaps empty; prints a list of as many
//   {"id", "end", "lines", "revealed", "counts"}
// id and end are of how the program ended, empty if it didn't; lines and counts are of the failed
// case, empty without one; and revealed is lines with what is right of a hidden case, for those who
// may know.
//
// Exit status 3 for what isn't such a list.
#include <iostream>
#include <nlohmann/json.hpp>

#include "ending.hpp"
#include "failed_case.hpp"
#include "sentences.hpp"

namespace bounce::words {
namespace {

using nlohmann::json;

// JSON has no NaN and no infinity: the judge writes them as texts.
double number_from(const json& x) {
  return x.is_string() ? std::stod(x.get<std::string>()) : x.get<double>();
}

Rows rows_from(const json& rows) {
  Rows all;
  for (const json& row : rows) {
    all.emplace_back();
    for (const json& x : row) all.back().push_back(number_from(x));
  }
  return all;
}

FailedCase failed_case_from(const json& facts) {
  FailedCase failed;
  facts.at("cases").get_to(failed.cases);
  facts.at("wrong").get_to(failed.wrong);
  facts.at("ended_at").get_to(failed.ended_at);
  facts.at("again").get_to(failed.again);
  facts.at("name").get_to(failed.name);
  facts.at("input").get_to(failed.input);
  facts.at("hidden").get_to(failed.hidden);
  facts.at("contact").get_to(failed.contact);
  facts.at("sentence").get_to(failed.sentence);
  for (const json& q : facts.at("quantities")) {
    failed.quantities.push_back({q.at("name"), q.at("unit"), rows_from(q.at("got")),
                                 rows_from(q.at("expected")), q.at("right")});
  }
  return failed;
}

json said_of(const json& verdict) {
  SaidEnding end;
  const json &ended = verdict.at("ended"), &failure = verdict.at("failure");
  if (!ended.is_null()) end = said({ended.at("what"), ended.at("number"), ended.at("text")});
  const std::string place = verdict.at("place"), found = verdict.at("found");
  if (!place.empty()) end.sentence += ", at " + place;
  json all = {
      {"id", end.id}, {"end", end.sentence}, {"lines", ""}, {"revealed", ""}, {"counts", ""}};
  if (failure.is_null()) return all;
  FailedCase failed = failed_case_from(failure);
  if (failed.ended_at > 0) failed.sentence = end.sentence;
  const std::string checked = found.empty() ? "" : "\n  checked  " + found;
  all["lines"] = lines(failed, false) + checked;
  all["revealed"] = lines(failed, true) + checked;
  all["counts"] = counts(failed);
  return all;
}

}  // namespace
}  // namespace bounce::words

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: words FOLDER, as in its main.cpp");
  bounce::words::sentences_folder = argv[1];
  nlohmann::json all = nlohmann::json::array();
  for (const auto& verdict : nlohmann::json::parse(std::cin))
    all.push_back(bounce::words::said_of(verdict));
  std::cout << all.dump() << std::endl;
  return std::cout ? 0 : 3;
} catch (const std::exception& e) {
  std::cerr << "words: " << e.what() << std::endl;
  return 3;
}
