// report WORDS HINTS [FACTS | --reveal]
//
// Says a score record's facts in sentences, with those in the folder WORDS and the hints in the
// folder HINTS. Reads {"parts": [...], "endings": [...]} as grader/bounce_grader/grading/record.py
// describes it, from the file FACTS or from standard input, and prints the same: for each part what
// a reader gets, and for each ending a sentence, if there are any. With --reveal, what is right of
// hidden cases is told, too.
//
// Exit status 3 for what isn't such a record.
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "report.hpp"
#include "sentences.hpp"
#include "tables.hpp"

namespace bounce::words {
namespace {

using json = nlohmann::ordered_json;

// --- reading facts ---

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

std::vector<Value> values_from(const json& values) {
  std::vector<Value> all;
  for (const json& x : values) all.push_back({x.at("name"), rows_from(x.at("rows")), x.at("unit")});
  return all;
}

// The units of what can be asked, by name.
Value asked_value(const std::string& name, const json& x) {
  static const std::map<std::string, std::string> units{
      {"J", ""},      {"l", "m"},  {"m", "kg"},    {"mu", ""},      {"epsilon", ""},
      {"g", "m/s^2"}, {"dt", "s"}, {"delta", "m"}, {"T", "columns"}};
  const auto unit = units.find(name);
  json rows = json::array();
  for (const json& row : x.is_array() ? x : json{x})
    rows.push_back(row.is_array() ? row : json{row});
  const char* vector = name[0] == 'q' ? "m, m, rad" : "m/s, m/s, rad/s";
  return {name, rows_from(rows), unit == units.end() ? vector : unit->second};
}

Question question_from(const json& asked) {
  Question question;
  for (const auto& [name, x] : asked.items())
    if (name != "params") question.input.push_back(asked_value(name, x));
  // In the assignment's order, which a record doesn't keep.
  const json& params = asked.at("params");
  for (const char* name : {"l", "m", "mu", "epsilon", "g", "dt", "delta", "T"})
    if (params.contains(name)) question.parameters.push_back(asked_value(name, params.at(name)));
  return question;
}

std::optional<Smallest> smallest_from(const json& facts) {
  if (facts.is_null()) return {};
  Smallest smallest;
  if (!facts.at("before").is_null()) smallest.before = question_from(facts.at("before"));
  smallest.asked = question_from(facts.at("input"));
  smallest.expected = {facts.at("quantity"), rows_from(facts.at("expected")), facts.at("unit")};
  smallest.got = rows_from(facts.at("got"));
  for (const json& x : facts.at("on_the_way"))
    smallest.on_the_way.push_back(
        {{x.at("name"), rows_from(x.at("rows")), x.at("unit")}, x.at("equation")});
  return smallest;
}

FailedCase failed_case_from(const json& facts, const json& answer) {
  FailedCase failed;
  facts.at("cases").get_to(failed.cases);
  facts.at("wrong").get_to(failed.wrong);
  facts.at("ended_at").get_to(failed.ended_at);
  facts.at("again").get_to(failed.again);
  facts.at("always_zero").get_to(failed.always_zero);
  facts.at("name").get_to(failed.name);
  facts.at("hidden").get_to(failed.hidden);
  facts.at("sentence").get_to(failed.sentence);
  failed.input = values_from(facts.at("input"));
  failed.parameters = values_from(facts.at("parameters"));
  answer.at("contact").get_to(failed.contact);
  for (const json& q : facts.at("quantities")) {
    const std::size_t i = failed.quantities.size();
    failed.quantities.push_back({q.at("name"), q.at("unit"), rows_from(q.at("got")),
                                 rows_from(answer.at("expected").at(i)), q.at("right")});
  }
  return failed;
}

Ending ending_from(const json& ended) {
  return {ended.at("what"), ended.at("number"), ended.at("text")};
}

CheckFacts check_from(const json& check) {
  CheckFacts facts{
      check.at("id"),   check.at("title"), check.at("status"), check.at("passed"), {}, {}, "",
      check.at("found")};
  if (const json& ended = check.at("ended"); !ended.is_null()) facts.ended = ending_from(ended);
  if (const json& failure = check.at("failure"); !failure.is_null()) {
    facts.failed = failed_case_from(failure, check.at("answer"));
    facts.failed->smallest = smallest_from(check.at("smallest"));
  }
  if (check.contains("place")) {
    const json& place = check.at("place");
    facts.place =
        place.at("file").get<std::string>() + ":" + std::to_string(place.at("line").get<int>());
  }
  return facts;
}

std::vector<Fact> facts_from(const json& facts) {
  std::vector<Fact> all;
  for (const json& fact : facts) all.push_back({fact.at("id"), fact.at("words")});
  return all;
}

PartFacts part_from(const json& part) {
  PartFacts facts;
  facts.stem = part.at("stem");
  facts.status = part.at("status");
  if (const json& why = part.at("why"); !why.is_null())
    facts.why = Fact{why.at("id"), why.at("words")};
  facts.notes = facts_from(part.at("notes"));
  for (const json& m : part.at("mistakes"))
    facts.mistakes.push_back(
        {m.at("title"), m.at("sentence"), m.at("hint"), m.at("equations"), m.at("checks")});
  for (const json& p : part.at("patterns"))
    facts.patterns.push_back({p.at("id"), p.at("words"), p.at("about")});
  for (const json& check : part.at("checks")) facts.checks.push_back(check_from(check));
  return facts;
}

// --- writing what readers get ---

// What is shown of the failed case in numbers.
json shown(const json& check, bool reveal) {
  json shown = check.at("failure");
  for (const char* name : {"cases", "wrong", "ended_at", "again", "always_zero"}) shown.erase(name);
  const bool is_told = reveal || !shown.at("hidden");
  const json& answer = check.at("answer");
  shown["contact"] = is_told ? answer.at("contact") : json("");
  for (std::size_t i = 0; i < shown.at("quantities").size() && is_told; ++i)
    shown["quantities"][i]["expected"] = answer.at("expected").at(i);
  return shown;
}

json told(const json& check, const SaidCheck& said, const json& mistakes, bool reveal) {
  json all = check;
  for (const char* name : {"status", "ended", "failure", "answer", "smallest", "found"})
    all.erase(name);
  all["message"] = said.message;
  all["mistake"] = said.mistake ? mistakes.at(*said.mistake) : json();
  all["hint"] = {{"heading", said.hint.heading}, {"nudge", said.hint.nudge}};
  const bool is_shown = check.at("status") == "graded" && !said.refers;
  if (is_shown && !check.at("failure").is_null()) all["shown"] = shown(check, reveal);
  return all;
}

// The part with the smallest case of its first check that has one, and of no other.
json with_one_smallest(json part) {
  part["smallest"] = nullptr;
  for (json& check : part.at("checks")) {
    if (part["smallest"].is_null()) {
      part["smallest"] = check.at("smallest");
    } else {
      check["smallest"] = nullptr;
    }
  }
  return part;
}

json told(const json& given, bool reveal) {
  const json part = with_one_smallest(given);
  const PartFacts facts = part_from(part);
  const SaidPart said = say(facts, reveal);
  json all = part;
  for (const char* name : {"why", "notes"}) all.erase(name);
  all["message"] = said.message;
  for (std::size_t i = 0; i < facts.mistakes.size(); ++i) {
    all["mistakes"][i].erase("checks");
    all["mistakes"][i]["where"] = where_to_read(facts.mistakes[i]);
  }
  all["patterns"] = json::array();
  for (const Pattern& pattern : facts.patterns)
    all["patterns"].push_back(tests::sentence_of(pattern));
  all["remarks"] = json::array();
  for (const Fact& remark : facts_from(part.at("remarks")))
    all["remarks"].push_back(sentence_of(remark));
  for (std::size_t i = 0; i < facts.checks.size(); ++i)
    all["checks"][i] = told(part.at("checks").at(i), said.checks[i], all["mistakes"], reveal);
  return all;
}

}  // namespace
}  // namespace bounce::words

int main(int argc, char** argv) try {
  using namespace bounce::words;
  if (argc != 3 && argc != 4) throw std::runtime_error("usage: see its main.cpp");
  const bool reveal = argc == 4 && argv[3] == std::string("--reveal");
  sentences_folder = argv[1];
  hints_folder = argv[2];
  const bool is_in_a_file = argc == 4 && !reveal;
  std::ifstream facts(is_in_a_file ? argv[3] : "");
  json all = json::parse(is_in_a_file ? facts : std::cin);
  for (json& part : all.at("parts")) part = told(part, reveal);
  if (all.contains("endings")) {
    for (json& ended : all["endings"]) ended = ended.is_null() ? "" : said(ending_from(ended));
  }
  std::cout << all.dump() << std::endl;
  return std::cout ? 0 : 3;
} catch (const std::exception& e) {
  std::cerr << "report: " << e.what() << std::endl;
  return 3;
}
