#include "findings.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr std::size_t kParameters = 7;  // among the inputs; they come first

std::vector<Value> inputs_of(const Case& c) {
  const Parameters& p = c.params;
  return {{"l", p.l},
          {"m", p.m},
          {"mu", p.mu},
          {"epsilon", p.epsilon},
          {"g", p.g(0) + 100 * p.g(1)},
          {"dt", p.dt},
          {"delta", p.delta},
          {"x", c.q(0)},
          {"y", c.q(1)},
          {"theta", c.q(2)}};
}

// The inputs in which two questions differ; nothing if they differ in v, J or T.
std::optional<Words> differing(const Case& a, const Case& b) {
  if (a.v != b.v || a.J != b.J || a.params.T != b.params.T) return std::nullopt;
  Words names;
  const std::vector<Value> of_a = inputs_of(a), of_b = inputs_of(b);
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (of_a[i].value != of_b[i].value) names.push_back(of_a[i].words);
  }
  return names;
}

// What was seen of an input and a quantity in all questions that differ in this input alone.
struct Seen {
  bool ought_to = false;   // the right answers differ somewhere
  bool responds = false;   // the part's differ somewhere
  bool everywhere = true;  // the part's differ each time
};

struct Part {
  std::vector<Quantity> quantities;
  const std::vector<Answer>&right, &got;
};

void look(const Part& part, const Quantity& quantity, std::size_t a, std::size_t b, Seen& seen) {
  bool right_differs = false, got_differs = false;
  for (const Index i : quantity.entries) {
    if (i >= part.got[a].numbers.size() || i >= part.got[b].numbers.size()) continue;
    right_differs = right_differs || !same(part.right[a].numbers(i), part.right[b].numbers(i));
    got_differs = got_differs || !same(part.got[a].numbers(i), part.got[b].numbers(i));
  }
  seen.ought_to = seen.ought_to || right_differs;
  seen.responds = seen.responds || got_differs;
  seen.everywhere = seen.everywhere && got_differs;
}

// Whether a quantity is 0 in all answers: then it isn't filled in, which is said in other words.
bool is_zero(const Part& part, const Quantity& quantity) {
  return std::all_of(part.got.begin(), part.got.end(), [&](const Answer& answer) {
    return std::all_of(quantity.entries.begin(), quantity.entries.end(), [&](Index i) {
      return i >= answer.numbers.size() || answer.numbers(i) == 0;
    });
  });
}

// Whether one of these sentences says what a quantity is: "The 3x3 block of your V is ...".
bool are_about(const Words& formulas, const Quantity& quantity) {
  return std::any_of(formulas.begin(), formulas.end(), [&](std::string words) {
    words.erase(std::min(words.find(" is "), words.size()));
    words[0] = words[0] == 'J' ? 'J' : static_cast<char>(std::tolower(words[0]));
    if (const std::size_t at = words.find("your "); at != words.npos) words.erase(at, 5);
    const bool is_rule = words.rfind("every wrong", 0) == 0;  // of wrong numbers, not of all
    return !is_rule && words.find(quantity.name) != words.npos;
  });
}

std::string sentence(const Words& names, const Words& quantities, bool intrudes) {
  const bool one = quantities.size() == 1;
  const std::string change = one ? " changes" : " change", stay = one ? " stays" : " stay";
  return "Where only " + joined(names, " or ") + " is changed, " + joined(quantities) +
         (intrudes ? change + " in your answers, and " : stay + " the same in your answers, and ") +
         (one ? "it" : "they") + " should " + (intrudes ? "stay the same." : "change.");
}

// One sentence for all inputs that have the same quantities.
Words grouped(const std::vector<std::pair<std::string, Words>>& found, bool intrudes) {
  std::vector<std::pair<Words, Words>> groups;  // quantities, and their inputs
  for (const auto& [input, quantities] : found) {
    if (quantities.empty()) continue;
    const auto group =
        std::find_if(groups.begin(), groups.end(),
                     [&, &these = quantities](const auto& g) { return g.first == these; });
    if (group == groups.end()) {
      groups.push_back({quantities, {input}});
    } else {
      group->second.push_back(input);
    }
  }
  Words sentences;
  for (const auto& [quantities, names] : groups) {
    sentences.push_back(sentence(names, quantities, intrudes));
  }
  return sentences;
}

// In free flight these make no difference. Where none of them does, the program takes no contact
// step in these questions, which is another mistake.
void leave_out_what_needs_a_contact(std::vector<std::pair<std::string, Words>>& missing) {
  const auto needs_a_contact = [](const auto& m) {
    return m.first == "l" || m.first == "mu" || m.first == "epsilon";
  };
  const auto none = std::count_if(missing.begin(), missing.end(), [&](const auto& m) {
    return needs_a_contact(m) && !m.second.empty();
  });
  if (none == 3) std::erase_if(missing, needs_a_contact);
}

// Inputs, each with the quantities in which it makes no difference.
using Missing = std::vector<std::pair<std::string, Words>>;

// Whether a quantity is right wherever all inputs that it lacks are those of the first question,
// which are not the assignment's, and mostly wrong elsewhere: then the program may keep them from
// its first call.
bool may_be_kept(const Part& part, const Quantity& quantity, const std::vector<Case>& cases,
                 const Missing& missing) {
  const auto lacks = [&](const std::string& input) {
    return std::any_of(missing.begin(), missing.end(), [&](const auto& m) {
      return m.first == input && std::count(m.second.begin(), m.second.end(), quantity.name) > 0;
    });
  };
  const std::vector<Value> first = inputs_of(cases.front()), usual = inputs_of({});
  std::size_t others = 0, wrong = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const std::vector<Value> now = inputs_of(cases[k]);
    bool as_first = true;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (!lacks(first[i].words)) continue;
      const bool is_parameter = i < kParameters;
      if (!is_parameter || first[i].value == usual[i].value) return false;
      as_first = as_first && now[i].value == first[i].value;
    }
    const bool is_wrong =
        std::any_of(quantity.entries.begin(), quantity.entries.end(), [&](Index i) {
          return i < part.got[k].numbers.size() &&
                 !same(part.got[k].numbers(i), part.right[k].numbers(i));
        });
    if (as_first && is_wrong) return false;
    others += !as_first;
    wrong += is_wrong;
  }
  return 2 * wrong >= others;
}

// Takes from the inputs those that a program may keep from its first call.
Missing take_kept(const Part& part, const std::vector<Case>& cases, Missing& missing) {
  Missing kept;
  const Missing all = missing;
  for (auto& [input, names] : missing) {
    Words of_first;
    for (const Quantity& quantity : part.quantities) {
      const auto at = std::find(names.begin(), names.end(), quantity.name);
      if (at == names.end() || !may_be_kept(part, quantity, cases, all)) continue;
      of_first.push_back(*at);
      names.erase(at);
    }
    kept.push_back({input, of_first});
  }
  return kept;
}

std::vector<Quantity> quantities_of(int part, const std::vector<Answer>& right) {
  if (part != 4) return quantities(part);
  Index most = 0;
  for (const Answer& answer : right) most = std::max(most, answer.numbers.size());
  return {{"the trajectory", range(0, most), {}}};
}

}  // namespace

bool answers_differ_when_asked_again(const std::vector<Case>& cases,
                                     const std::vector<Answer>& got) {
  for (std::size_t a = 0; a < cases.size(); ++a) {
    for (std::size_t b = a + 1; b < cases.size(); ++b) {
      const auto names = differing(cases[a], cases[b]);
      if (names && names->empty() && !same(got[a], got[b])) return true;
    }
  }
  return false;
}

Words inputs(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
             const std::vector<Answer>& got, const Words& formulas) {
  const Part all{quantities_of(part, right), right, got};
  std::map<std::string, std::vector<Seen>> seen;
  for (std::size_t a = 0; a < cases.size(); ++a) {
    for (std::size_t b = a + 1; b < cases.size(); ++b) {
      if (!is_finite(right[a], got[a]) || !is_finite(right[b], got[b])) continue;
      const auto names = differing(cases[a], cases[b]);
      if (!names || names->size() != 1) continue;
      auto& of_input = seen[names->front()];
      of_input.resize(all.quantities.size());
      for (std::size_t i = 0; i < all.quantities.size(); ++i) {
        look(all, all.quantities[i], a, b, of_input[i]);
      }
    }
  }
  std::vector<std::pair<std::string, Words>> missing, intruding;
  for (const Value& input : inputs_of(cases.front())) {
    Words without, with;
    for (std::size_t i = 0; i < all.quantities.size() && seen.count(input.words) > 0; ++i) {
      const Seen& what = seen[input.words][i];
      if (is_zero(all, all.quantities[i]) || are_about(formulas, all.quantities[i])) continue;
      // Where only a threshold depends on it, no difference may be chance.
      const bool is_threshold = input.words == std::string(part == 3   ? "y"
                                                           : part == 4 ? "delta"
                                                                       : "");
      if (what.ought_to && !what.responds && !is_threshold)
        without.push_back(all.quantities[i].name);
      const bool is_move = part == 3 && i == 0;  // it tells of v', too, where v' doesn't move q
      if (what.everywhere && !what.ought_to && !is_move) with.push_back(all.quantities[i].name);
    }
    missing.push_back({input.words, without});
    intruding.push_back({input.words, with});
  }
  if (part >= 3) leave_out_what_needs_a_contact(missing);
  Words sentences;
  for (std::string words : grouped(take_kept(all, cases, missing), false)) {
    words.back() = ':';
    sentences.push_back(words + " kept from an earlier call?");
  }
  for (const std::string& words : grouped(missing, false)) sentences.push_back(words);
  for (const std::string& words : grouped(intruding, true)) sentences.push_back(words);
  return sentences;
}

}  // namespace bounce::tests
