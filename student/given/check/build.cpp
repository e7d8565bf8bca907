#include <algorithm>
#include <chrono>
#include <set>
#include <thread>
#include <tuple>

#include "files.hpp"
#include "process.hpp"
#include "run.hpp"
#include "words.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

const fs::path kBuild = kWork / "build.txt", kWarnings = kWork / "warnings",
               kSources = kWork / "sources";

// Touches the files that have changed, since a build looks at times alone, and one may come back
// with an old one, as from a zip. Forgets their warnings; and all others, too, where what is
// included has changed.
void note_changes() {
  const std::string before = read(kSources), now = state_of_sources();
  std::set<std::string> unchanged;
  bool is_all_compiled = false;
  for (const std::string& line : lines_of(now)) {
    const std::string file = line.substr(line.find(' ') + 1);
    if (has(before, line + "\n")) {
      unchanged.insert(file);
      continue;
    }
    std::error_code gone;
    if (!before.empty()) fs::last_write_time(file, fs::file_time_type::clock::now(), gone);
    const bool is_new = !has(before, " " + file + "\n");
    is_all_compiled = is_all_compiled || (!is_new && fs::path(file).extension() != ".cpp");
  }
  std::string kept;
  for (const std::string& line : lines_of(read(kWarnings))) {
    if (!is_all_compiled && unchanged.count(file_of(line))) kept += line + "\n";
  }
  write(kWarnings, kept);
  write(kSources, now);
}

void build_part(Run& run, Part& part) {
  for (const int earlier : part.calls) {
    part.broken = part.broken ? part.broken : run.part(earlier).broken;
  }
  if (part.broken || build_programs({target_of(run, part)})) return;
  part.broken = &part;
  part.error = first_error(own_lines(read(kBuild)));
  part.error.is_of_linker = build_programs({part.stem, "helpers"});
}

}  // namespace

void build_parts(Run& run) {
  for (const Part& part : run.all) {
    if (fs::exists(part.file())) continue;
    throw Failure(part.file() + " is missing: copy it from the handout's zip");
  }
  note_changes();
  std::vector<std::string> targets;
  std::set<int> needed;
  for (const Part* part : run.chosen) {
    targets.push_back(target_of(run, *part));
    needed.insert(part->number);
    needed.insert(part->calls.begin(), part->calls.end());
  }
  if (build_programs(targets)) return;
  if (check::run({"cmake", "-S", ".", "-B", "build"}, kBuild, Limits::none) != 0) {
    throw Failure("CMake could not prepare the build:\n" + read(kBuild));
  }
  for (const int number : needed) build_part(run, run.part(number));
}

bool build_programs(const std::vector<std::string>& targets) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::string> command{
      "cmake",   "--build", "build", "--config", "Debug", "--parallel", std::to_string(cores),
      "--target"};
  command.insert(command.end(), targets.begin(), targets.end());
  fs::remove(kBuild);
  const auto ended = run(command, kBuild, Limits::none);
  if (!ended) throw Failure("CMake isn't found any more: install it again");
  std::string all = read(kWarnings);
  for (const std::string& line : own_lines(read(kBuild))) {
    if (is_warning_of_own_file(line) && !has(all, line + "\n")) all += line + "\n";
  }
  write(kWarnings, all);
  return *ended == 0;
}

std::vector<std::string> warnings() {
  std::vector<std::string> all = lines_of(read(kWarnings));
  std::sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
    return std::tuple(file_of(a), line_of(a), a) < std::tuple(file_of(b), line_of(b), b);
  });
  return all;
}

std::string state_of_sources() {
  std::set<std::string> lines;
  std::error_code gone;
  for (const char* folder : {"src", "include"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder, gone)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".cpp" && ending != ".hpp" && ending != ".tpp" && ending != ".h") continue;
      const std::size_t digest = std::hash<std::string>{}(read(entry.path()));
      lines.insert(std::to_string(digest) + " " + entry.path().generic_string() + "\n");
    }
  }
  std::string state;
  for (const std::string& line : lines) state += line;
  return state;
}

std::string once_after_a_change(const std::string& name, const std::function<std::string()>& find) {
  const fs::path file = kWork / (name + "_found.txt");
  const std::string now = state_of_sources() + "\n", before = read(file);
  if (begins(before, now)) return before.substr(now.size());
  const std::string found = find();
  write(file, now + found);
  return found;
}

}  // namespace bounce::check
