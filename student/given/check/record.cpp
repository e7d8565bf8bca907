#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "files.hpp"
#include "process.hpp"
#include "report.hpp"
#include "words.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

// As JSON; what isn't printable is left out.
std::string in_quotes(const std::string& text) {
  std::string all = "\"";
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') all += '\\';
    all += c;
  }
  return all + "\"";
}

std::string number(int x) { return std::to_string(x); }

// "file:12" or "file:12:3" as a place in what is handed in; "" is none.
std::string place_of(const std::string& place) {
  const std::string file = file_of(place);
  if (file.empty()) return "";
  const std::size_t colon = place.find(':', file.size() + 1);
  const int column = colon == std::string::npos ? 0 : std::atoi(place.c_str() + colon + 1);
  return ", \"place\": {\"file\": " + in_quotes(file) + ", \"line\": " + number(line_of(place)) +
         ", \"column\": " + number(column) + "}";
}

// A check's status as the score record names it.
std::string status_of(const Note& note) {
  if (!note.ended) return "graded";
  const std::string& what = note.ended->what;
  if (what == "worked" || what == "waited") return "timed_out";
  const bool has_ended = what == "exited" || what == "printed" || what == kNotAsked;
  return has_ended ? "no_answer" : "crashed";
}

std::string ended_of(const Note& note) {
  if (!note.ended) return "null";
  return "{\"what\": " + in_quotes(note.ended->what) +
         ", \"number\": " + std::to_string(note.ended->number) +
         ", \"text\": " + in_quotes(note.ended->text) + "}";
}

std::string check_of(const Check& check, const Note& note) {
  const bool passed = note.status == "passed";
  const std::string none = "{\"failure\": null, \"answer\": null, \"smallest\": null}\n";
  const bool is_of_a_case = !passed && note.status != kUndecided && !note.facts.empty();
  std::string facts = is_of_a_case ? note.facts : none;
  facts = facts.substr(1, facts.rfind('}') - 1);
  return "{\"id\": " + in_quotes(check.id) + ", \"title\": " + in_quotes(check.title) +
         ", \"score\": " + number(passed ? check.points : 0) +
         ", \"max_score\": " + number(check.points) +
         ", \"passed\": " + (passed ? "true" : "false") +
         ", \"status\": " + in_quotes(status_of(note)) + ", \"ended\": " + ended_of(note) + ", " +
         facts + ", \"found\": \"\"" + place_of(note.place) + "}";
}

std::string why(const Part& part) {
  if (!part.broken) return "null";
  return "{\"id\": \"not_built\", \"words\": [" + in_quotes(part.broken->error.sentence) + "]}";
}

std::string notes_of(const Part& part) {
  if (part.undecided() == 0) return "";
  return "{\"id\": \"undecided\", \"words\": [" + in_quotes(number(part.undecided())) + "]}";
}

// The known mistakes and patterns as facts, where a check failed by its numbers.
std::string mistakes_of(const Run& run, const Part& part) {
  const std::string none = "\"mistakes\": [], \"patterns\": []";
  for (const Check& check : part.checks) {
    if (part.broken || part.result.note(check).status == "passed") continue;
    mistake_of(run, part, check);
    const std::string facts = read(kWork / "mistake.txt.json");
    return facts.empty() ? none : facts.substr(1, facts.rfind('}') - 1);
  }
  return none;
}

std::string part_of(const Run& run, const Part& part) {
  std::string checks, status = part.broken ? "does_not_compile" : "graded";
  std::string place = part.broken ? part.broken->error.place : "";
  if (place.empty()) place = (part.broken ? part.broken : &part)->file() + ":0";
  for (const Check& check : part.checks) {
    const Note note = part.broken ? Note{} : part.result.note(check);
    if (note.ended && status == "graded") {
      status = status_of(note);
      if (!note.place.empty()) place = note.place;
    }
    checks += (checks.empty() ? "" : ",\n") + check_of(check, note);
  }
  return "{\"part\": " + number(part.number) + ", \"stem\": " + in_quotes(part.stem) +
         ", \"title\": " + in_quotes(part.title) + ", \"score\": " + number(part.worth()) +
         ", \"max_score\": " + number(part.points) + ", \"status\": " + in_quotes(status) +
         ", \"graded_with\": " + (part.is_given ? "\"given\"" : "\"own\"") +
         ", \"why\": " + why(part) + ", \"notes\": [" + notes_of(part) + "], " +
         mistakes_of(run, part) + ", \"remarks\": [],\n\"checks\": [" + checks + "]" +
         place_of(place) + "}";
}

}  // namespace

void write_record(const Run& run, const std::string& file) {
  std::string parts;
  for (const Part* part : run.chosen) parts += (parts.empty() ? "" : ",\n") + part_of(run, *part);
  const fs::path facts = kWork / "facts.json", told = kWork / "record.json";
  write(facts, "{\"score\": " + number(run.score) + ", \"max_score\": " + number(run.possible) +
                   ", \"parts\": [" + parts + "]}\n");
  if (!build_programs({"report"})) throw Failure("the record's program can't be built");
  fs::remove(told);
  const std::vector<std::string> command{"build/report", "given/words", "hints",
                                         facts.generic_string()};
  if (check::run(command, told, Limits::none) != 0) throw Failure("no record: " + read(told));
  write(file, read(told));
}

}  // namespace bounce::check
