#include "sentences.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace bounce::words {
namespace {

// With ' for the quotation marks of all compilers.
std::string plainly_quoted(std::string text) {
  for (const std::string quote : {"\u2018", "\u2019", "`", "\""}) {
    for (std::size_t at = 0; (at = text.find(quote, at)) != std::string::npos;)
      text.replace(at, quote.size(), "'");
  }
  return text;
}

const std::string kBetween = " | ";

Sentences read_sentences(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " is missing: unpack the kit again");
  Sentences all;
  std::string sentence;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("  ", 0) != 0) {
      sentence = line;
    } else {
      line.erase(0, 2);
      for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + kBetween.size()) {
        end = line.find(kBetween, at);
        all.emplace_back(line.substr(at, end - at), sentence);
      }
    }
  }
  return all;
}

}  // namespace

const Sentences& sentences(const std::string& file) {
  static std::map<std::string, Sentences> read;
  const auto known = read.find(file);
  if (known != read.end()) return known->second;
  return read[file] = read_sentences(sentences_folder / file);
}

std::string sentence_of(const std::string& file, const std::string& id) {
  for (const auto& [known, sentence] : sentences(file)) {
    if (known == id) return sentence;
  }
  return "";
}

std::string meaning_in(const std::string& file, const std::string& text) {
  const std::string plain = plainly_quoted(text);
  for (const auto& [piece, sentence] : sentences(file)) {
    if (plain.find(piece) != std::string::npos) return sentence;
  }
  return "";
}

std::string filled(std::string sentence,
                   const std::vector<std::pair<std::string, std::string>>& values) {
  std::string text;
  for (std::size_t from = 0; from < sentence.size();) {
    const std::size_t open = std::min(sentence.find('{', from), sentence.size());
    const std::size_t close = std::min(sentence.find('}', open), sentence.size());
    text += sentence.substr(from, open - from);
    for (const auto& [name, value] : values) {
      if (sentence.compare(open, close - open, "{" + name) == 0) text += value;
    }
    from = close + 1;
  }
  return text;
}

std::string one_line(const std::string& text, std::size_t most) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  if (line.size() <= most) return line;
  while (most > 0 && (static_cast<unsigned char>(line[most]) & 0xC0) == 0x80) --most;
  return line.substr(0, most) + "...";
}

}  // namespace bounce::words
