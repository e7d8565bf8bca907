#include "table.hpp"

#include <sys/utsname.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace bounce::study {
namespace {

std::string quoted(const std::string& value) {
  if (value.find_first_of(",\"\n") == std::string::npos) return value;
  std::string text = "\"";
  for (const char c : value) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string line(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ",") + quoted(value);
  return text + "\n";
}

// The value of the first line of /proc/cpuinfo with this name.
std::string cpu(const std::string& name) {
  std::ifstream in("/proc/cpuinfo");
  for (std::string text; std::getline(in, text);) {
    if (text.rfind(name + "\t", 0) == 0)
      return text.substr(std::min(text.size(), text.find(':') + 2));
  }
  return "unknown";
}

// Names such as "AMD EPYC" stand for many processors, which family, model and stepping tell apart.
std::string processor() {
  return cpu("model name") + " (family " + cpu("cpu family") + ", model " + cpu("model") +
         ", stepping " + cpu("stepping") + ", " + cpu("cpu MHz") + " MHz)";
}

std::string kernel() {
  utsname name{};
  return uname(&name) == 0 ? std::string(name.sysname) + " " + name.release : "unknown kernel";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%d", &date);
  return text;
}

std::string pinned(int core) {
  return core < 0 ? "not pinned" : "pinned to core " + std::to_string(core);
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

void Table::add_row(std::vector<std::string> row) {
  if (row.size() != columns_.size()) throw std::logic_error("a row has another number of columns");
  rows_.push_back(std::move(row));
}

void Table::write(const std::string& file, const std::vector<std::string>& origin) const {
  std::ofstream out(file, std::ios::binary);
  for (const std::string& text : origin) out << text << "\n";
  out << line(columns_);
  for (const auto& row : rows_) out << line(row);
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file);
}

std::vector<std::string> origin(const std::string& times) {
  std::vector<std::string> lines{
      "# machine: " + processor() + ", " + std::to_string(std::thread::hardware_concurrency()) +
          " cores, " + kernel(),
      "# compiler: " + compiler(), "# flags: -std=c++20 " BOUNCE_FLAGS, "# date: " + today()};
  if (!times.empty()) lines.push_back("# times: " + times);
  return lines;
}

std::string times_taken(int core) {
  return "CPU time, " + pinned(core) +
         ", the median of the scenes, for each the least of five runs";
}

std::string times_taken(int core, const Extent& extent) {
  return "CPU time, " + pinned(core) + ", the median of " + std::to_string(extent.rounds) +
         " rounds in which all take turns, each at least " + text_of(extent.least_ns / 1e6, 5) +
         " ms; what takes over " + text_of(kLongNs / 1e6, 5) + " ms plays in one round of " +
         std::to_string(kLongEvery);
}

}  // namespace bounce::study
