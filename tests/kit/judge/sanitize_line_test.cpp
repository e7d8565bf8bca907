// Turning a submission's text into one line of printable characters.
#include "../../../grader/judge/sanitize_line.hpp"

#include <gtest/gtest.h>

#include <string>

namespace bounce::tests {
namespace {

using namespace std::string_literals;

TEST(SanitizeLine, LeavesOneLineThatPrints) {
  const std::string bad = "\xEF\xBF\xBD";
  const std::pair<std::string, std::string> rows[] = {
      {"", ""},
      {"q is 3x149, <b>&amp;=1+1,;", "q is 3x149, <b>&amp;=1+1,;"},
      {"Übung ½ θ → 日本 🙂", "Übung ½ θ → 日本 🙂"},
      {"a\nb\r\tc", "a b  c"},
      {"\x1b[2J\a\x7f", bad + "[2J" + bad + bad},
      {"a\0b"s, "a" + bad + "b"},
      {"\u009b31m", bad + "31m"},
      {"\u202egnorw\u2066\u200f\ufeff\u2028", bad + "gnorw" + bad + bad + bad + bad},
      {"Gr\xf6\xdf!", "Gr" + bad + bad + "!"},      // Latin-1
      {"\xc0\xaf", bad + bad},                      // overlong
      {"\xed\xa0\x80", bad + bad + bad},            // a surrogate
      {"\xf4\x90\x80\x80", bad + bad + bad + bad},  // past the last
      {"\xe2\x82", bad + bad},                      // cut off
      {std::string(41, 'a'), std::string(40, 'a') + "..."},
      {"θθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθ", "θθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθθ"},
  };
  for (const auto& [text, line] : rows) EXPECT_EQ(judge::sanitize_line(text, 40), line);
}

}  // namespace
}  // namespace bounce::tests
