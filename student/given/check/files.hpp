// Small things about files and text that the check program needs in several places.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounce::check {

inline const std::filesystem::path kWork = "build/check";  // what the program keeps between runs

// Ends the program with one sentence and exit status 3.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The whole file without carriage returns, as a text of any system; empty where it can't be read.
std::string read(const std::filesystem::path& file);

// The bytes from `begin` to before `end`.
std::string read(const std::filesystem::path& file, std::size_t begin, std::size_t end);

// Replaces the file in one step. Throws Failure.
void write(const std::filesystem::path& file, const std::string& text);

std::vector<std::string> lines_of(const std::string& text);
std::vector<std::string> split(const std::string& text, char separator);

// Printable ASCII and UTF-8 as it is; nothing that could steer a terminal.
std::string printable(const std::string& text);

// Breaks lines at blanks so that they have at most `width` characters; each begins with `indent`.
std::string folded(const std::string& text, std::size_t width, const std::string& indent);

}  // namespace bounce::check
