#include "run.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "failed_case.hpp"
#include "files.hpp"
#include "hints.hpp"
#include "process.hpp"
#include "words.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

constexpr int kMostHung = 2;  // checks of a part that may hang

// AddressSanitizer reserves far more memory than it uses.
Limits limits_of(const Run& run) { return run.sanitized ? Limits::none : Limits::of_a_part; }

// From a file of a part's program: "STATUS [FROM TO]" and what there is to say.
Note read_note(const fs::path& file) {
  const std::string text = read(file);
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::istringstream words(text.substr(0, end));
  Note note;
  words >> note.status >> note.from;
  if (std::size_t to = 0; words >> to) note.to = to;
  note.text = text.substr(std::min(end + 1, text.size()));
  note.facts = read(file.string() + ".json");
  return note;
}

// Whether an earlier part that this one calls is wrong, as far as public checks can tell.
bool is_an_earlier_wrong(Run& run, const Part& part) {
  return std::any_of(part.calls.begin(), part.calls.end(), [&](int number) {
    Part& earlier = run.part(number);
    if (earlier.broken || earlier.is_given) return true;
    if (earlier.result.notes.empty()) {  // where only one part was run
      if (!build_programs({target_of(run, earlier)})) return true;
      earlier.result = run_checks(run, earlier, target_of(run, earlier));
    }
    return earlier.worth() < earlier.points;
  });
}

// With recorded answers in place of the earlier parts, too: the better result stays.
void run_with_given(Run& run, Part& part) {
  Part given = part;
  given.result = run_checks(run, part, given_target_of(part));
  const bool is_left = given.undecided() + given.worth(kOpen) > 0;
  const bool waits = is_left && is_an_earlier_wrong(run, part);
  // What is left undecided or open is as it was with the student's own parts, if it passed or if
  // those are right. What else is open has passed.
  for (const Check& check : part.checks) {
    Note& note = given.result.notes[check.id];
    if (note.status != kUndecided && note.status != kOpen) continue;
    const Note own = part.result.note(check);
    if (own.status == "passed" || (own.status != "unknown" && !waits)) {
      note = own;
      note.to.reset();  // it was printed elsewhere
    } else if (note.status == kOpen) {
      note.status = "passed";
    }
  }
  const bool decides_more = waits && given.undecided() > 0;
  const int gain = given.worth() - part.worth();
  if (!part.broken && gain <= 0 && !(gain == 0 && decides_more)) return;
  part.own = part.result;
  part.result = given.result;
  part.is_given = true;
  part.broken = nullptr;
}

// Whether it may get more points with given earlier parts.
bool may_gain(const Run& run, const Part& part) {
  const bool compiles = part.broken != &part || part.error.is_of_linker;
  return compiles && part.worth() < part.points && !run.sanitized && !part.calls.empty();
}

// A fault of an earlier part that its own public checks don't ask.
void find_fault_of_earlier(Run& run, const Part& part) {
  if (!part.is_given || is_an_earlier_wrong(run, part)) return;
  if (part.worth() < part.points) return;  // that it is wrong itself comes first
  for (const Check& check : part.checks) {
    const Note own = part.own.note(check);
    if (own.status == "passed" || own.text.empty()) continue;
    run.fault_shows_in = &part;
    run.fault = own.text;
    return;
  }
}

}  // namespace

int Part::worth(const std::string& status) const {
  int sum = 0;
  for (const Check& check : checks) {
    if (result.note(check).status == status) sum += check.points;
  }
  return sum;
}

Run read_run(int part, bool sanitized) {
  Run run;
  run.sanitized = sanitized;
  for (const std::string& line : lines_of(read("tests/checks.txt"))) {
    const std::vector<std::string> cells = split(line, '\t');
    if (cells.size() >= 5 && cells[0] == "part") {
      run.all.push_back({std::stoi(cells[1]), cells[2], cells[4], std::stoi(cells[3])});
      for (const std::string& stem : split(cells.size() > 5 ? cells[5] : "", ' '))
        run.all.back().calls.push_back(std::stoi(stem.substr(4)));  // "part1_contacts"
    } else if (cells.size() == 4 && !run.all.empty()) {
      run.all.back().checks.push_back({cells[1], cells[3], std::stoi(cells[2])});
    }
  }
  if (run.all.empty()) throw Failure("tests/checks.txt is missing: unpack the handout again");
  for (Part& each : run.all) {
    if (!part || part == each.number) run.chosen.push_back(&each);
  }
  return run;
}

Result run_checks(const Run& run, const Part& part, const std::string& target) {
  const std::string number = std::to_string(part.number);
  const bool is_given = target == given_target_of(part);
  const fs::path notes = kWork / "notes", stack = kWork / "stack.txt",
                 prints = kWork / ("printed_" + number + (is_given ? "_given.txt" : ".txt"));
  Result result{"build/" + target, prints.generic_string()};
  fs::remove_all(notes);
  fs::create_directories(notes);
  write(prints, "");
  std::vector<std::string> command{result.program, "--notes", notes.string(), result.prints};
  if (!run.sanitized) command.push_back(stack.string());  // sanitizers say it themselves
  int hung = 0;
  for (bool again = true; again;) {
    again = false;
    fs::remove(stack);
    const auto ended = check::run(command, prints, limits_of(run));
    if (!ended) throw Failure(result.program + " can't be started: remove the folder build");
    const std::string printed = read(prints), cause = cause_in(stack);
    const std::string place = place_of_crash(result.program, stack);
    for (const Check& check : part.checks) {
      if (result.notes.count(check.id) || !fs::exists(notes / check.id)) continue;
      Note& note = result.notes[check.id] = read_note(notes / check.id);
      const bool hangs = note.status == "hung";
      if (note.status != "running" && !hangs) continue;
      const int end = hangs && *ended != kWaited ? kTooLong : *ended;
      const std::string at = place.empty() ? "" : ", at " + place;
      note.status = hangs ? "hung" : "crashed";
      note.text += "\n" + words::got(reason_of(end, printed, cause) + at);
      note.to = fs::file_size(prints);
      note.ended = ending_of(end, printed, cause);
      note.place = place;
      hung += hangs;
      if (hangs && is_terminal()) std::cerr << "A check gave no answer; trying the others.\n";
      again = hung < kMostHung && *ended != -SIGXFSZ;
    }
    if (!result.notes.empty()) continue;
    for (const Check& check : part.checks) {  // as where a global object's constructor crashes
      Note& note = result.notes[check.id];
      note.status = "crashed";
      note.text = "Before the first check began, " + reason_of(*ended, printed, cause) +
                  "\nLook at what runs before main: objects outside of functions, and what their "
                  "constructors do.\n";
      note.ended = ending_of(*ended, printed, cause);
    }
  }
  for (const Check& check : part.checks) {
    if (hung == kMostHung && result.notes.count(check.id) == 0)
      result.notes[check.id].ended = words::Ending{kNotAsked};
  }
  return result;
}

void run_parts(Run& run) {
  std::vector<std::string> targets;
  for (Part* part : run.chosen) {
    if (!part->broken) part->result = run_checks(run, *part, target_of(run, *part));
    if (may_gain(run, *part)) targets.push_back(given_target_of(*part));
  }
  const bool are_built = targets.empty() || build_programs(targets);
  for (Part* part : run.chosen) {
    if (may_gain(run, *part) && (are_built || build_programs({given_target_of(*part)})))
      run_with_given(run, *part);
  }
  for (const Part* part : run.chosen) {
    run.possible += part->points;
    run.score += part->worth();
    run.undecided += part->undecided();
    if (!run.fault_shows_in) find_fault_of_earlier(run, *part);
    if ((part->broken || part->error.is_of_linker) && !run.first_part) run.first_part = part;
    for (const Check& check : part->checks) {
      const std::string status = part->result.note(check).status;
      if (status == "passed" || status == kUndecided || run.first_part) continue;
      run.first_part = part;
      run.first_check = &check;
    }
  }
}

Mistake mistake_of(const Run& run, const Part& part, const Check& check) {
  const Mistake unknown{words::hint_of(part.stem, check.id).heading, ""};
  const fs::path found = kWork / "mistake.txt";
  for (const char* file : {"mistake.txt", "mistake.txt.json"}) fs::remove(kWork / file);
  for (const auto& [id, note] : part.result.notes) {
    if (note.status == "crashed" || note.status == "hung") return unknown;
  }
  check::run({part.result.program, "--mistake", found.string(), part.stem, check.id},
             kWork / "nobody_reads.txt", limits_of(run));
  fs::remove(kWork / "nobody_reads.txt");
  const std::string text = read(found);
  const std::size_t end = std::min(text.find('\n'), text.size());
  return end == 0 ? unknown : Mistake{text.substr(0, end), text.substr(end + 1)};
}

}  // namespace bounce::check
