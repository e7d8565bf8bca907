#include "build.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>
#include <thread>

#include "compiler_words.hpp"
#include "files.hpp"
#include "process.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

const fs::path kBuild = kWork / "build.txt", kWarnings = kWork / "warnings",
               kSources = kWork / "sources";

void remember_warnings(const std::vector<std::string>& said) {
  std::vector<std::string> all = lines_of(read(kWarnings));
  for (const std::string& line : said) {
    if (is_warning_of_own_file(line)) all.push_back(line);
  }
  std::string text;
  for (const std::string& line : std::set<std::string>(all.begin(), all.end())) text += line + "\n";
  write(kWarnings, text);
}

// Those of other files still stand, unless what is included has changed.
void forget_warnings(const std::string& file) {
  std::string text;
  for (const std::string& line : lines_of(read(kWarnings))) {
    if (fs::path(file).extension() == ".cpp" && file_of(line) != file) text += line + "\n";
  }
  write(kWarnings, text);
}

// A build looks at times alone, and a file may come back with an old one, as from a zip.
void touch_what_changed() {
  const std::string now = state_of_sources();
  const std::vector<std::string> before = lines_of(read(kSources)), after = lines_of(now);
  const auto file_of_those = [](const std::vector<std::string>& these,
                                const std::vector<std::string>& not_in) {
    std::set<std::string> files;
    for (const std::string& line : these) {
      const bool is_new = std::find(not_in.begin(), not_in.end(), line) == not_in.end();
      if (is_new) files.insert(line.substr(line.find(' ') + 1));
    }
    return files;
  };
  for (const std::string& file : file_of_those(before, after)) forget_warnings(file);
  for (const std::string& file : file_of_those(after, before)) {
    std::error_code gone;
    if (!before.empty()) fs::last_write_time(file, fs::file_time_type::clock::now(), gone);
  }
  write(kSources, now);
}

bool build_targets(const std::vector<std::string>& targets) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::string> command{
      "cmake",   "--build", "build", "--config", "Debug", "--parallel", std::to_string(cores),
      "--target"};
  command.insert(command.end(), targets.begin(), targets.end());
  fs::remove(kBuild);
  const auto ended = run(command, kBuild, Limits::none);
  if (!ended) throw Failure("CMake isn't found any more: install it again");
  remember_warnings(own_lines(read(kBuild)));
  return ended->code == 0 && ended->signal == 0;
}

void build_part(Run& run, const Part& part) {
  for (const int earlier : part.calls) {
    if (run.unbuilt.count(earlier)) {
      run.unbuilt[part.number] = run.unbuilt[earlier];
      return;
    }
  }
  if (build_targets({run.target(part)})) return;
  run.unbuilt[part.number] = part.number;
  const std::vector<std::string> said = own_lines(read(kBuild));
  if (is_linker_error(said)) run.unlinked.insert(part.number);
  const std::string meaning = meaning_of(said);
  run.errors[part.number] =
      first_error(said) + (meaning.empty() ? "" : "\n" + folded(meaning, 74, "  "));
}

}  // namespace

void build_parts(Run& run) {
  for (const Part& part : run.all) {
    if (fs::exists(part.file())) continue;
    throw Failure(part.file() + " is missing: copy it from the handout's zip");
  }
  touch_what_changed();
  std::vector<std::string> targets;
  std::set<int> needed;
  for (const int number : run.chosen) {
    targets.push_back(run.target(run.part(number)));
    needed.insert(number);
    needed.insert(run.part(number).calls.begin(), run.part(number).calls.end());
  }
  if (build_targets(targets)) return;
  const std::string said = read(kBuild);
  if (said.find("CMake Error") != std::string::npos) {
    throw Failure("CMake could not prepare the build:\n" + said);
  }
  for (const int number : needed) build_part(run, run.part(number));
}

std::vector<const Part*> build_given(const Run& run, const std::vector<const Part*>& parts) {
  std::vector<std::string> targets;
  for (const Part* part : parts) targets.push_back(run.given_target(*part));
  if (targets.empty() || build_targets(targets)) return parts;
  std::vector<const Part*> built;
  for (const Part* part : parts) {
    if (build_targets({run.given_target(*part)})) built.push_back(part);
  }
  return built;
}

bool build_program(const std::string& name) { return build_targets({name}); }

std::vector<std::string> warnings() {
  std::vector<std::string> all = lines_of(read(kWarnings));
  std::stable_sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
    return std::pair(file_of(a), line_of(a)) < std::pair(file_of(b), line_of(b));
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
  return std::accumulate(lines.begin(), lines.end(), std::string());
}

std::string once_after_a_change(const std::string& name, bool still_there,
                                const std::function<std::string()>& find) {
  const fs::path file = kWork / (name + "_found.txt");
  const std::string now = state_of_sources() + "\n", before = read(file);
  if (still_there && before.rfind(now, 0) == 0) return before.substr(now.size());
  const std::string found = find();
  write(file, now + found);
  return found;
}

}  // namespace bounce::check
