#include "files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace bounce::check {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  return text;
}

std::string read(const fs::path& file, std::size_t begin, std::size_t end) {
  std::ifstream in(file, std::ios::binary);
  std::string text(end > begin ? end - begin : 0, '\0');
  in.seekg(static_cast<std::streamoff>(begin));
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

void write(const fs::path& file, const std::string& text) {
  fs::path part = file;
  part += ".new";
  std::error_code failed;
  if (std::ofstream out(part, std::ios::binary); !(out << text << std::flush)) {
    throw Failure(file.string() + " can't be written: is the disk full, or the folder read-only?");
  }
  fs::rename(part, file, failed);
  if (failed) throw Failure(file.string() + " can't be written: " + failed.message());
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, separator);) words.push_back(word);
  return words;
}

std::string printable(const std::string& text) {
  std::string shown;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) shown += c;
  }
  return shown;
}

std::string folded(const std::string& text, std::size_t width, const std::string& indent) {
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
