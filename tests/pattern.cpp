#include "pattern.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <set>

#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;
using Words = std::vector<std::string>;

constexpr std::size_t kEnough = 3;  // numbers or cases, below which a rule may be chance
constexpr double kFewDigits = 1e-4;
constexpr double kRounding = 1e-9;  // below which a number stands for 0

// A name and the entries of an answer that it stands for.
struct Quantity {
  std::string name;
  std::vector<Index> entries;
  Words names;  // of the entries, where a name alone says too little
};

std::vector<Index> range(Index from, Index count, Index step = 1) {
  std::vector<Index> all;
  for (Index i = 0; i < count; ++i) all.push_back(from + i * step);
  return all;
}

std::vector<Quantity> quantities(int part) {
  const Words entries{"first entry", "second entry", "third entry"};
  if (part == 1) {
    return {{"J_t", range(0, 3), entries}, {"J_n", range(3, 3), entries}, {"phi", {6}, {}}};
  }
  if (part == 2) {
    return {{"the 3x3 block of V", {0, 1, 2, 4, 5, 6, 8, 9, 10}, {}},
            {"the last column of V", range(12, 4), {}},
            {"the last row of V", range(3, 3, 4), {}},
            {"p(0)", {16}, {}},
            {"p(1)", {17}, {}},
            {"p(2)", {18}, {}},
            {"p(3)", {19}, {}}};
  }
  return {{"the move q' - q - dt v'", range(0, 3), {"x", "y", "theta"}},
          {"v'", range(3, 3), {"v_x", "v_y", "omega"}}};
}

// --- the wrong numbers ---

struct Number {
  std::size_t question;
  Index entry;
  double right, got;
};

// Wrong answers beside right ones. What threw isn't among them.
struct Wrong {
  std::vector<Number> numbers;
  std::set<std::size_t> questions;
  std::set<Index> entries;
};

Wrong wrong_numbers(const std::vector<Answer>& right, const std::vector<Answer>& got) {
  Wrong wrong;
  for (std::size_t k = 0; k < got.size(); ++k) {
    if (got[k].numbers.size() != right[k].numbers.size()) continue;
    for (Index i = 0; i < got[k].numbers.size(); ++i) {
      if (same(right[k].numbers(i), got[k].numbers(i))) continue;
      wrong.numbers.push_back({k, i, right[k].numbers(i), got[k].numbers(i)});
      wrong.questions.insert(k);
      wrong.entries.insert(i);
    }
  }
  return wrong;
}

// --- words ---

std::string joined(const Words& words, const std::string& last = " and ") {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
  }
  return text;
}

std::string capital(std::string text) {
  const bool is_word = text.size() > 1 && text.rfind("the ", 0) == 0;
  if (is_word) text[0] = 'T';
  return text;
}

std::string digits(double x) {
  if (std::isnan(x)) return "not a number";
  if (x == 0) return "0";  // without the sign that zero may have
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

// --- which quantities ---

// "J_t (third entry)", or the name alone where all entries are wrong.
std::string with_entries(const Quantity& quantity, const std::set<Index>& wrong) {
  Words names;
  for (std::size_t i = 0; i < quantity.names.size(); ++i) {
    if (wrong.count(quantity.entries[i]) > 0) names.push_back(quantity.names[i]);
  }
  if (names.empty() || names.size() == quantity.names.size()) return quantity.name;
  return quantity.name + " (" + joined(names) + ")";
}

bool is_touched(const Quantity& quantity, const std::set<Index>& wrong) {
  return std::any_of(quantity.entries.begin(), quantity.entries.end(),
                     [&](Index i) { return wrong.count(i) > 0; });
}

std::string which(int part, const Wrong& wrong) {
  Words right, touched;
  for (const Quantity& quantity : quantities(part)) {
    const bool is_wrong = is_touched(quantity, wrong.entries);
    (is_wrong ? touched : right)
        .push_back(is_wrong ? with_entries(quantity, wrong.entries) : quantity.name);
  }
  const std::string what = "wrong: " + joined(touched) + ".";
  return right.empty() ? "W" + what.substr(1)
                       : "Right in every public case: " + joined(right) + "; " + what;
}

// --- in which cases ---

// Something that some cases have and others haven't.
struct Trait {
  std::string words;  // follows "where"
  std::function<bool(const Case&)> has;
};

void add_parameters(std::vector<Trait>& traits) {
  const auto other = [&](const std::string& name, auto member) {
    traits.push_back(
        {name, [member](const Case& c) { return c.params.*member != Parameters().*member; }});
  };
  other("l", &Parameters::l);
  other("m", &Parameters::m);
  other("mu", &Parameters::mu);
  other("epsilon", &Parameters::epsilon);
  other("g", &Parameters::g);
  other("dt", &Parameters::dt);
  other("delta", &Parameters::delta);
}

Trait saying(const std::string& words) {
  return {words, [words](const Case& c) { return c.corner.find(words) != std::string::npos; }};
}

Trait not_saying(const std::string& corner) {
  return {corner + " is not the lowest",
          [corner](const Case& c) { return c.corner.find(corner) == std::string::npos; }};
}

void add_what_the_corner_does(std::vector<Trait>& traits) {
  for (const char* corner : {"corner 1", "corner 2", "corner 3", "corner 4"}) {
    traits.push_back({corner + std::string(" is the lowest"), saying(corner).has});
    traits.push_back(not_saying(corner));
  }
  for (const char* mode : {"slides", "slides to the right", "slides to the left", "sticks",
                           "leaves the ground", "no corner touches"}) {
    traits.push_back(saying(mode));
    if (mode[0] != 'n') traits.back().words = "the corner " + traits.back().words;
  }
  traits.push_back({"a corner touches", [](const Case& c) {
                      return c.corner.find("touches") != std::string::npos &&
                             c.corner.rfind("no ", 0) != 0;
                    }});
}

void add_motion(int part, std::vector<Trait>& traits) {
  if (part == 2) {
    traits.push_back({"the corner slides to the right before the step",
                      [](const Case& c) { return c.J.col(0).dot(c.v) > 0; }});
    traits.push_back({"the corner slides to the left before the step",
                      [](const Case& c) { return c.J.col(0).dot(c.v) < 0; }});
    traits.push_back({"the corner comes down before the step",
                      [](const Case& c) { return c.J.col(1).dot(c.v) < 0; }});
    return;
  }
  traits.push_back({"theta is negative", [](const Case& c) { return c.q(2) < 0; }});
  traits.push_back({"theta is more than a turn",
                    [](const Case& c) { return std::abs(c.q(2)) > 2 * std::numbers::pi; }});
}

std::set<std::size_t> those_with(const Trait& trait, const std::vector<Case>& cases) {
  std::set<std::size_t> found;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (trait.has(cases[k])) found.insert(k);
  }
  return found;
}

bool includes(const std::set<std::size_t>& all, const std::set<std::size_t>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

// The traits that fit best: those that the fewest cases have which are right.
struct Fit {
  Words words;
  std::set<std::size_t> cases;
};

std::optional<Fit> closest(const std::vector<Trait>& traits, const std::vector<Case>& cases,
                           const std::set<std::size_t>& wrong) {
  std::optional<Fit> best;
  for (const Trait& trait : traits) {
    const auto with = those_with(trait, cases);
    if (!includes(with, wrong) || with.size() == cases.size()) continue;
    if (best && with == best->cases) {
      best->words.push_back(trait.words);
    } else if (!best || with.size() < best->cases.size()) {
      best = Fit{{trait.words}, with};
    }
  }
  return best;
}

std::string out_of(const Fit& fit, const std::set<std::size_t>& wrong) {
  const auto all = std::to_string(fit.cases.size()), some = std::to_string(wrong.size());
  return fit.cases.size() == wrong.size() ? "in all " + all + " such cases"
                                          : "in " + some + " of " + all + " such cases";
}

bool are_nearly_all(const std::set<std::size_t>& wrong, const std::set<std::size_t>& cases) {
  return 4 * wrong.size() >= 3 * cases.size();
}

// Which a law of its own explains better than that some number is another.
std::string where_gravity_is_not_vertical(const std::vector<Case>& cases,
                                          const std::set<std::size_t>& wrong) {
  const Trait sideways{"gravity has an x part", [](const Case& c) { return c.params.g(0) != 0; }};
  const auto fit = closest({sideways}, cases, wrong);
  if (!fit || !are_nearly_all(wrong, fit->cases)) return "";
  return "Wrong only where " + sideways.words + ", " + out_of(*fit, wrong) + ".";
}

// The other cases are right; a trait has to set apart more than chance would.
std::string where(int part, const std::vector<Case>& cases, const std::set<std::size_t>& wrong) {
  if (wrong.empty() || cases.size() - wrong.size() < kEnough) return "";
  const std::string sideways = where_gravity_is_not_vertical(cases, wrong);
  if (!sideways.empty()) return sideways;
  std::vector<Trait> parameters, others;
  add_parameters(parameters);
  add_what_the_corner_does(others);
  add_motion(part, others);
  const auto numbers = closest(parameters, cases, wrong), traits = closest(others, cases, wrong);
  if (numbers && (!traits || numbers->cases.size() <= traits->cases.size())) {
    return "Wrong only where " + joined(numbers->words, " or ") +
           (numbers->words.size() > 1 ? " aren't" : " isn't") + " the assignment's, " +
           out_of(*numbers, wrong) + ": is a number written down that params holds?";
  }
  if (!traits || !are_nearly_all(wrong, traits->cases)) return "";
  return "Wrong only where " + traits->words.front() + ", " + out_of(*traits, wrong) + ".";
}

// --- by what rule ---

bool is_rule(const std::vector<Number>& numbers, const std::function<double(const Number&)>& rule) {
  return numbers.size() >= kEnough && std::all_of(numbers.begin(), numbers.end(), [&](auto& n) {
           return n.right != 0 && same(rule(n), n.got);
         });
}

std::string factor_of(const std::vector<Case>& cases, const std::vector<Number>& numbers) {
  if (numbers.empty()) return "";
  const auto names = factors(cases[numbers[0].question].params);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto scaled = [&](const Number& n) {
      return factors(cases[n.question].params)[i].second * n.right;
    };
    if (is_rule(numbers, scaled)) return names[i].first;
  }
  const double ratio = numbers[0].got / numbers[0].right;
  const bool constant = is_rule(numbers, [&](const Number& n) { return ratio * n.right; });
  return constant && ratio != 0 ? digits(ratio) : "";
}

std::string difference_of(const std::vector<Number>& numbers) {
  if (numbers.empty()) return "";
  const double difference = numbers[0].got - numbers[0].right;
  const bool constant = is_rule(numbers, [&](const Number& n) { return n.right + difference; });
  return constant ? digits(std::abs(difference)) + (difference > 0 ? " more" : " less") : "";
}

std::string constant_of(const std::vector<Number>& numbers) {
  if (numbers.empty()) return "";
  const bool is_one = is_rule(numbers, [&](const Number&) { return numbers[0].got; });
  const bool varies = std::any_of(numbers.begin(), numbers.end(), [&](const Number& n) {
    return !same(n.right, numbers[0].right);
  });
  const bool is_rounding = numbers[0].got != 0 && std::abs(numbers[0].got) < kRounding;
  return is_one && varies && !is_rounding ? digits(numbers[0].got) : "";
}

std::string rule_of(const std::string& subject, const std::vector<Case>& cases,
                    const std::vector<Number>& numbers) {
  const std::string constant = constant_of(numbers), factor = factor_of(cases, numbers);
  if (!constant.empty()) return subject + " is " + constant + ", whatever the question.";
  if (!factor.empty()) return subject + " is " + factor + " times the right one.";
  const std::string difference = difference_of(numbers);
  return difference.empty() ? "" : subject + " is " + difference + " than the right one.";
}

bool few_digits(const std::vector<Number>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const Number& n) {
    return std::abs(n.got - n.right) < kFewDigits * std::max(1e-3, std::abs(n.right));
  });
}

// One rule for every wrong number, or one for each quantity that has its own.
Words rules(int part, const std::vector<Case>& cases, const Wrong& wrong) {
  if (few_digits(wrong.numbers)) {
    return {
        "The wrong numbers are right to four digits or more: is there a float, or a constant with "
        "too few digits?"};
  }
  const std::string all = rule_of("Every wrong number", cases, wrong.numbers);
  if (!all.empty()) return {all};
  Words found;
  for (const Quantity& quantity : quantities(part)) {
    std::vector<Number> own;
    std::copy_if(wrong.numbers.begin(), wrong.numbers.end(), std::back_inserter(own),
                 [&](const Number& n) { return is_touched(quantity, {n.entry}); });
    const std::string subject = own.empty() || quantity.entries.size() == 1
                                    ? capital(quantity.name)
                                    : "Every wrong number in " + quantity.name;
    const std::string own_rule = rule_of(subject, cases, own);
    if (!own_rule.empty() && found.size() < 2) found.push_back(own_rule);
  }
  return found;
}

// --- exchanged places ---

struct Exchange {
  int part;
  std::string words;
  std::vector<Index> from;  // where each entry comes from
};

std::vector<Exchange> exchanges() {
  const auto matrix = [](Index rows, auto&& from) {
    std::vector<Index> all = range(0, 20);
    for (Index j = 0; j < rows; ++j) {
      for (Index i = 0; i < rows; ++i) all[static_cast<std::size_t>(i + 4 * j)] = from(i, j);
    }
    return all;
  };
  std::vector<Index> p_swapped = range(0, 20);
  std::swap(p_swapped[17], p_swapped[18]);
  return {{1, "the two columns of J are exchanged", {3, 4, 5, 0, 1, 2, 6}},
          {1, "J is filled row by row with what belongs into its columns", {0, 2, 4, 1, 3, 5, 6}},
          {2, "V is transposed", matrix(4, [](Index i, Index j) { return j + 4 * i; })},
          {2, "p(1) and p(2) are exchanged", p_swapped}};
}

bool explains(const Exchange& exchange, const std::vector<Answer>& right,
              const std::vector<Answer>& got) {
  for (std::size_t k = 0; k < got.size(); ++k) {
    for (Index i = 0; i < got[k].numbers.size(); ++i) {
      const Index from = exchange.from[static_cast<std::size_t>(i)];
      if (!same(right[k].numbers(from), got[k].numbers(i))) return false;
    }
  }
  return true;
}

std::string exchanged(int part, const std::vector<Answer>& right, const std::vector<Answer>& got) {
  for (const Exchange& exchange : exchanges()) {
    if (exchange.part == part && explains(exchange, right, got)) {
      return "One thing explains every wrong number: " + exchange.words + ".";
    }
  }
  return "";
}

// --- part 4 ---

std::string first_wrong_column(const std::vector<Case>& cases, const Wrong& wrong) {
  std::set<int> firsts;
  for (const std::size_t k : wrong.questions) {
    const auto first = std::find_if(wrong.numbers.begin(), wrong.numbers.end(),
                                    [&](const Number& n) { return n.question == k; });
    const auto column = static_cast<std::size_t>(first->entry / numbers_together(4));
    firsts.insert(known_columns(cases[k].params.T)[column]);
  }
  if (firsts.empty()) return "";
  if (*firsts.begin() < 2 && firsts.size() == 1) {
    return "Column " + std::to_string(*firsts.begin()) +
           " is the first wrong one in every case that is wrong.";
  }
  return *firsts.begin() == 0
             ? "In some cases column 0 is wrong already."
             : "Column 0 is right in every public case; the first wrong one comes after it.";
}

// A stub's answers: the checks say enough of them.
bool nothing_is_filled_in(const std::vector<Answer>& got) {
  return std::all_of(got.begin(), got.end(), [](const Answer& a) { return a.numbers.isZero(0); });
}

void add(Words& sentences, const std::string& sentence) {
  if (!sentence.empty()) sentences.push_back(sentence);
}

}  // namespace

std::vector<std::pair<std::string, double>> factors(const Parameters& p) {
  return {{"-1", -1},
          {"2", 2},
          {"1/2", 0.5},
          {"dt", p.dt},
          {"1/dt", 1 / p.dt},
          {"m", p.m},
          {"1/m", 1 / p.m},
          {"m^2", p.m * p.m},
          {"epsilon", p.epsilon},
          {"1 + epsilon", 1 + p.epsilon},
          {"1/(1 + epsilon)", 1 / (1 + p.epsilon)}};
}

std::vector<std::string> patterns(int part, const std::vector<Case>& cases,
                                  const std::vector<Answer>& right,
                                  const std::vector<Answer>& got) {
  if (got.size() != right.size() || got.size() != cases.size()) return {};
  const Wrong wrong = wrong_numbers(right, got);
  if (wrong.numbers.empty() || nothing_is_filled_in(got)) return {};
  Words sentences;
  if (part == 4) {
    add(sentences, first_wrong_column(cases, wrong));
    add(sentences, where(part, cases, wrong.questions));
    return sentences;
  }
  add(sentences, which(part, wrong));
  add(sentences, where(part, cases, wrong.questions));
  const std::string exchange = exchanged(part, right, got);
  for (const std::string& rule : exchange.empty() ? rules(part, cases, wrong) : Words{exchange}) {
    add(sentences, rule);
  }
  return sentences;
}

}  // namespace bounce::tests
