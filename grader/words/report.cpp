#include "report.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "sentences.hpp"

namespace bounce::words {
namespace {

const std::string kReport = "report.txt";

std::string end_of(const CheckFacts& check) {
  if (!check.ended) return "";
  return said(*check.ended) + (check.place.empty() ? "" : ", at " + check.place);
}

// Its case in lines, where there is one; else how the program ended.
std::string message_of(const CheckFacts& check, bool reveal) {
  if (!check.failed) return end_of(check);
  FailedCase failed = *check.failed;
  if (failed.ended_at > 0) failed.sentence = end_of(check);
  const std::string found =
      check.found.empty() ? "" : "\n  checked  " + said({"sanitizer", 0, check.found});
  return lines(failed, reveal) + found;
}

// The exception of the failed case, or how the program crashed: the same in several checks is told
// once. Empty for wrong numbers.
std::string reason_of(const CheckFacts& check) {
  if (check.status == "crashed") return end_of(check);
  const bool has_numbers = check.failed && !check.failed->quantities.empty();
  return check.status == "graded" && check.failed && !has_numbers ? check.failed->sentence : "";
}

std::string message_of(const PartFacts& part) {
  if (part.why) return sentence_of(*part.why);
  for (const CheckFacts& check : part.checks) {
    if (check.status != "graded") return end_of(check);
  }
  const auto passed = std::count_if(part.checks.begin(), part.checks.end(),
                                    [](const CheckFacts& check) { return check.passed; });
  const auto all = static_cast<std::ptrdiff_t>(part.checks.size());
  if (passed == all) return sentence_of(Fact{"all_right", {}});
  if (passed == 0) return sentence_of(Fact{"none_passed", {}});
  return sentence_of(Fact{"some_failed", {std::to_string(all - passed), std::to_string(all)}});
}

// The part's only mistake, or the first that costs the check.
std::optional<std::size_t> mistake_of(const PartFacts& part, const std::string& check) {
  if (part.mistakes.size() == 1) return 0;
  for (std::size_t i = 0; i < part.mistakes.size(); ++i) {
    const auto& costs = part.mistakes[i].checks;
    if (std::find(costs.begin(), costs.end(), check) != costs.end()) return i;
  }
  return {};
}

}  // namespace

std::string sentence_of(const Fact& fact) {
  std::vector<std::pair<std::string, std::string>> values;
  for (std::size_t i = 0; i < fact.words.size(); ++i)
    values.emplace_back(std::to_string(i), fact.words[i]);
  if (fact.id == "found") values.at(1).second = said({"sanitizer", 0, fact.words[1]});
  const std::string sentence = sentence_of(kReport, fact.id);
  if (sentence.empty()) throw std::runtime_error(kReport + " has no sentence for " + fact.id);
  return filled(sentence, values);
}

std::string where_to_read(const MistakeFacts& mistake) {
  std::string numbers;
  for (const int number : mistake.equations)
    numbers += (numbers.empty() ? "(" : ", (") + std::to_string(number) + ")";
  const std::string s = mistake.equations.size() == 1 ? "" : "s";
  return "eq" + s + ". " + numbers + " and hint " + mistake.hint;
}

Hint first_hint(const PartFacts& part, const std::string& check) {
  const auto mistake = mistake_of(part, check);
  if (mistake) return hint_named(part.stem, part.mistakes[*mistake].hint);
  return hint_of(part.stem, check, part.patterns);
}

SaidPart say(const PartFacts& part, bool reveal) {
  SaidPart said_part{message_of(part), {}};
  for (const Fact& note : part.notes) said_part.message += "; " + sentence_of(note);
  const bool has_run = !part.why && part.status != "does_not_compile";
  std::map<std::string, std::string> first;  // the title of the check, by the reason
  bool is_first = true;
  for (const CheckFacts& check : part.checks) {
    SaidCheck& said_check = said_part.checks.emplace_back();
    if (check.passed) continue;
    said_check.mistake = mistake_of(part, check.id);
    said_check.hint = is_first ? first_hint(part, check.id) : hint_of(part.stem, check.id);
    is_first = false;
    if (!has_run) continue;
    const std::string reason = reason_of(check);
    if (first.count(reason) > 0 && check.failed) {
      said_check.message = counts(*check.failed) + ", as in \"" + first[reason] + "\": " + reason;
      said_check.refers = true;
      continue;
    }
    if (!reason.empty()) first[reason] = check.title;
    said_check.message = message_of(check, reveal);
  }
  return said_part;
}

}  // namespace bounce::words
