// Small things about files and text that several programs need.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounce::check {

// Ends the program with one sentence and exit status 3.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The bytes from `begin` to before `end`, or the whole file, without carriage returns, as a text of
// any system; empty where it can't be read.
inline std::string read(const std::filesystem::path& file, std::size_t begin = 0,
                        std::size_t end = std::string::npos) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(begin));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text.erase(std::min(end - begin, text.size()));
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  return text;
}

// Replaces the file in one step, so that a reader sees the old one or the new one, never half of
// it. Throws Failure, and leaves the old one.
inline void write(const std::filesystem::path& file, const std::string& text) {
  const auto fail = [&](const std::string& reason) {
    throw Failure("cannot write " + file.string() + ": " + reason);
  };
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file))
    fail("it is there already and is not a file");
  std::filesystem::path part = file;
  part += ".part";
  std::ofstream out(part, std::ios::binary);
  if (!out) fail("its folder is missing or may not be written to");
  out << text;
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, file, failed);
  if (out && !failed) return;
  const std::string reason = out ? failed.message() : "the disk may be full";
  std::filesystem::remove(part, failed);
  fail(reason);
}

inline bool has(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}
inline bool begins(const std::string& text, const std::string& piece) {
  return text.rfind(piece, 0) == 0;
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, separator);) words.push_back(word);
  return words;
}
inline std::vector<std::string> lines_of(const std::string& text) { return split(text, '\n'); }

// Printable ASCII and UTF-8 as it is; nothing that could steer a terminal.
inline std::string printable(const std::string& text) {
  std::string shown;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) shown += c;
  }
  return shown;
}

// Breaks lines at blanks so that they have at most `width` characters; each begins with `indent`.
inline std::string folded(const std::string& text, std::size_t width, const std::string& indent) {
  std::string out;
  for (std::string line : lines_of(text)) {
    while (line.size() > width) {
      const std::size_t blank = line.rfind(' ', width - 1);
      const bool has_blank = blank != std::string::npos;
      out += indent + line.substr(0, has_blank ? blank : width) + "\n";
      line.erase(0, has_blank ? blank + 1 : width);
    }
    out += indent + line + "\n";
  }
  return out;
}

}  // namespace bounce::check
