#include "run.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>

#include "build.hpp"
#include "ending.hpp"
#include "files.hpp"
#include "process.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

constexpr int kMostHung = 2;  // checks of a part that may hang

fs::path notes_of(const Part& part) {
  return kWork / part.notes / ("part" + std::to_string(part.number));
}

// Those of the run with the student's own earlier parts, where given ones score better.
fs::path own_notes_of(const Part& part) {
  return kWork / "own_notes" / ("part" + std::to_string(part.number));
}

// From a file of a part's program: "STATUS [FROM TO]" and what there is to say.
Note read_note(const fs::path& file) {
  const std::string text = read(file);
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::vector<std::string> words = split(text.substr(0, end), ' ');
  Note note{words.empty() ? "unknown" : words[0], 0, 0, words.size() == 3, ""};
  if (words.size() > 1) note.from = std::stoul(words[1]);
  if (note.has_prints) note.to = std::stoul(words[2]);
  if (end < text.size()) note.text = text.substr(end + 1);
  return note;
}

void say_how_it_ended(const fs::path& file, const Note& note, const Termination& ended,
                      const std::string& printed, const std::string& place, std::uintmax_t size) {
  const bool hung = ended.signal == 0 && ended.code == kTooLong;
  write(file, (hung ? "hung " : "crashed ") + std::to_string(note.from) + " " +
                  std::to_string(size) + "\n" + reason_of(ended, printed) + place +
                  "\nIt was asked: " + note.text);
}

// As where a global object's constructor crashes: none of the checks was run.
void say_that_none_began(const fs::path& notes, const Part& part, const Termination& ended,
                         const std::string& printed) {
  const std::string text = "crashed\nBefore the first check began, " + reason_of(ended, printed) +
                           "\nLook at what runs before main: objects outside of functions, and "
                           "what their constructors do.\n";
  for (const Check& check : part.checks) write(notes / check.id, text);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

std::string program_of(const Run& run, const Part& part) {
  return "build/" + (run.given.count(part.number) ? run.given_target(part) : run.target(part));
}

// AddressSanitizer reserves far more memory than it uses.
Limits limits_of(const Run& run) { return run.sanitized ? Limits::none : Limits::of_a_part; }

// A check that crashes or hangs costs itself alone: the program is started again for the others.
void run_part(const Run& run, const Part& part) {
  const fs::path notes = notes_of(part), prints = prints_file(part.number);
  fs::remove_all(notes);
  fs::create_directories(notes);
  fs::remove(prints);
  write(prints, "");
  const fs::path stack = kWork / "stack.txt";
  std::vector<std::string> command{program_of(run, part), "--notes", notes.string(),
                                   prints.string()};
  if (!run.sanitized) command.push_back(stack.string());  // sanitizers say it themselves
  int hung = 0;
  for (bool again = true; again;) {
    again = false;
    fs::remove(stack);
    const auto ended = check::run(command, prints, limits_of(run));
    if (!ended) throw Failure(program_of(run, part) + " can't be started: remove the folder build");
    const std::string printed = read(prints);
    const std::string place = place_of_crash(command[0], stack);
    if (fs::is_empty(notes)) say_that_none_began(notes, part, *ended, printed);
    for (const fs::path& file : files_in(notes)) {
      const Note note = read_note(file);
      const bool is_new_hang = note.status == "hung" && note.text.rfind("no answer", 0) != 0;
      if (note.status != "running" && !is_new_hang) continue;
      say_how_it_ended(file, note, is_new_hang ? Termination{kTooLong, 0} : *ended, printed, place,
                       fs::file_size(prints));
      hung += is_new_hang;
      if (is_new_hang && is_terminal()) std::cerr << "A check gives no answer; asking others.\n";
      again = hung < kMostHung && ended->signal != kPrintedTooMuch;
    }
  }
}

int points_of(const Part& part, const std::string& status) {
  int points = 0;
  for (const Check& check : part.checks) {
    if (note_of(part, check).status == status) points += check.points;
  }
  return points;
}

// Whether an earlier part that this one calls is wrong, as far as public checks can tell.
bool is_an_earlier_wrong(const Run& run, const Part& part) {
  return std::any_of(part.calls.begin(), part.calls.end(), [&](int number) {
    const Part& earlier = run.part(number);
    if (run.unbuilt.count(number) || run.given.count(number)) return true;
    if (run.is_one_part()) {  // only that one was run
      if (!build_program(run.target(earlier))) return true;
      run_part(run, earlier);
    }
    return points_of(earlier) < earlier.points;
  });
}

// What is undecided with the given earlier parts is as it was with the student's own, if it passed
// or if those are right.
void fill_in(const Run& run, const Part& part) {
  const bool waits = undecided_of(run, part) > 0 && is_an_earlier_wrong(run, part);
  for (const Check& check : part.checks) {
    if (note_of(part, check).status != kUndecided) continue;
    const Note own = read_note(own_notes_of(part) / check.id);
    if (own.status == "passed" || (own.status != "unknown" && !waits))
      write(notes_of(part) / check.id, own.status + "\n" + own.text);
  }
}

// The better result stays.
void run_with_given(Run& run, const Part& part) {
  const fs::path notes = notes_of(part), prints = prints_file(part.number);
  const fs::path own_notes = own_notes_of(part), own_prints = kWork / "own_prints.txt";
  const bool has_own = !run.unbuilt.count(part.number);
  const int own_points = has_own ? points_of(part) : 0;
  fs::remove_all(own_notes);
  if (has_own) {
    fs::create_directories(own_notes.parent_path());
    fs::rename(notes, own_notes);
    fs::rename(prints, own_prints);
  }
  run.given.insert(part.number);
  run_part(run, part);
  fill_in(run, part);
  const int points = points_of(part);
  const bool own_decide_less = undecided_of(run, part) > 0 && is_an_earlier_wrong(run, part);
  if (!has_own || points > own_points || (points == own_points && own_decide_less)) {
    run.unbuilt.erase(part.number);
    return;
  }
  run.given.erase(part.number);
  fs::remove_all(notes);
  fs::rename(own_notes, notes);
  fs::rename(own_prints, prints);
}

// Whether it may get more points with given earlier parts.
bool may_gain(const Run& run, const Part& part) {
  const auto unbuilt = run.unbuilt.find(part.number);
  const bool is_built = unbuilt == run.unbuilt.end();
  const bool compiles =
      is_built || unbuilt->second != part.number || run.unlinked.count(part.number);
  const bool is_right = is_built && points_of(part) == part.points;
  return compiles && !is_right && !run.sanitized && !part.calls.empty();
}

// Runs them as they are, and where that isn't all right, with given earlier parts.
void judge(Run& run, const std::vector<const Part*>& parts) {
  for (const Part* part : parts) {
    if (!run.unbuilt.count(part->number)) run_part(run, *part);
  }
  std::vector<const Part*> may_gain_points;
  for (const Part* part : parts) {
    if (may_gain(run, *part)) may_gain_points.push_back(part);
  }
  for (const Part* part : build_given(run, may_gain_points)) run_with_given(run, *part);
}

// A fault of an earlier part that its own public checks don't ask.
void find_fault_of_earlier(Run& run, const Part& part) {
  if (!run.given.count(part.number) || is_an_earlier_wrong(run, part)) return;
  if (points_of(part) < part.points) return;  // that it is wrong itself comes first
  for (const Check& check : part.checks) {
    const Note own = read_note(own_notes_of(part) / check.id);
    if (own.status == "passed" || own.text.empty()) continue;
    run.fault_shows_in = &part;
    run.fault = own.text;
    return;
  }
}

}  // namespace

std::string prints_file(int part) {
  return (kWork / ("printed_" + std::to_string(part) + ".txt")).generic_string();
}

Note note_of(const Part& part, const Check& check) { return read_note(notes_of(part) / check.id); }

void run_parts(Run& run) {
  run.score = run.possible = run.undecided = 0;
  run.fault_shows_in = nullptr;
  run.first_part = nullptr;
  run.first_check = nullptr;
  std::vector<const Part*> chosen;
  for (const int number : run.chosen) chosen.push_back(&run.part(number));
  judge(run, chosen);
  for (const int number : run.chosen) {
    const Part& part = run.part(number);
    run.possible += part.points;
    if (!run.fault_shows_in) find_fault_of_earlier(run, part);
    if (run.unbuilt.count(number)) {
      if (!run.first_part) run.first_part = &part;
      continue;
    }
    run.undecided += undecided_of(run, part);
    if (run.unlinked.count(number) && !run.first_part) run.first_part = &part;  // with the others
    for (const Check& check : part.checks) {
      const std::string status = note_of(part, check).status;
      if (status == "passed") {
        run.score += check.points;
      } else if (status != kUndecided && !run.first_part) {
        run.first_part = &part;
        run.first_check = &check;
      }
    }
  }
}

int points_of(const Part& part) { return points_of(part, "passed"); }

int undecided_of(const Run& run, const Part& part) {
  return run.unbuilt.count(part.number) ? 0 : points_of(part, kUndecided);
}

std::string mistake_of(const Run& run, const Part& part) {
  for (const fs::path& file : files_in(notes_of(part))) {
    const std::string status = read_note(file).status;
    if (status == "crashed" || status == "hung") return "";
  }
  const fs::path told = kWork / ("mistake_" + std::to_string(part.number) + ".txt");
  fs::remove(told);
  check::run({program_of(run, part), "--mistake", told.string()}, kWork / "nobody_reads.txt",
             limits_of(run));
  fs::remove(kWork / "nobody_reads.txt");
  return read(told);
}

}  // namespace bounce::check
