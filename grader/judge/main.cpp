// judge JSON COMMAND...
//
// Runs the tests of a part against the runner that COMMAND starts. JSON holds
//   "part"        1 to 4
//   "fixtures"    folders
//   "given"       if true, the earlier parts are given
//   "backwards"   if true, each check begins with its last case
//   "sanitized"   if true, the runner has sanitizers
//   "boxed"       if true, COMMAND is a box (grader/box/enter.cpp), which reports when it is made
//   "seconds", "cpu_seconds"   for the whole part: checks that there is no time left for fail
//   "recognise", "answers", "watch"   see below
//
// Prints {"checks": [{"id", "passed", "status", "ended", "stack", "failure", "answer",
// "smallest"}],
//         "largest_error": number or null, "asked_given": bool, "mistakes": [known mistake],
//         "patterns": [{"id", "words", "about"}]}
// ended says how the program ended, if it did, {"what", "number", "text"}, and stack where it came;
// failure is the failed case in numbers, and answer what is right there, which students must not
// see if the case is hidden; null if the check passed, or failed as a whole. smallest is the
// simplest wrong case: without hidden cases, the public one in failure; with them and "recognise",
// of the first check with a wrong number, one that is looked for with more questions
// (smallest.hpp); else null (all three: tests/parts/facts.hpp). largest_error is the largest in
// public cases, and null if it isn't finite. asked_given says whether the program called the given
// part before. mistakes and patterns (recognise.hpp) are empty unless "recognise" is given and a
// check failed; then a second runner is asked the public cases.
//
// With "answers", it prints the runner's answers to the public cases instead: each is a list of
// numbers, with null for NaN and infinity, or the text of an exception. With "watch", it asks
// nothing, and prints in one line how the wait for an answer ended: for ./kit doctor, whose command
// breaks out of a box if it can.
//
// Exit status: 0 if every check has a verdict; 3, with a sentence on standard error, if the kit
// itself failed, which is no verdict about the submission.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

#include "../../tests/parts/checks.hpp"
#include "../../tests/parts/facts.hpp"
#include "../diagnosis/recognise.hpp"
#include "session.hpp"
#include "smallest.hpp"

namespace bounce {

using nlohmann::json;

static json asked;  // the first argument
static std::vector<std::string> command;

namespace judge {
namespace {

bool is_asked(const char* option) { return asked.value(option, false); }

Limits asked_limits() {
  Limits limits{.sanitized = is_asked("sanitized"), .boxed = is_asked("boxed")};
  limits.session_cpu_seconds = asked.value("cpu_seconds", limits.session_cpu_seconds);
  limits.session_seconds = asked.value("seconds", limits.session_seconds);
  limits.busy_wall_seconds = std::min(limits.busy_wall_seconds, limits.session_seconds);
  limits.wall_seconds = std::min<double>(limits.wall_seconds, limits.session_seconds);
  return limits;
}

std::unique_ptr<Session> new_session() {
  return std::make_unique<Session>(command, asked_limits(), asked.at("part"), is_asked("given"));
}

// A check's answers, and how its runner ended, if it did.
struct AskedCheck {
  tests::CheckAnswers asked;
  std::optional<Termination> end;

  bool is_asked(bool again) const { return !end && !(again && asked.check.asks_once); }
};

// The places of a check's cases in the order in which they are asked: public ones first.
// "backwards" begins with the last of each kind.
std::vector<std::size_t> order_of(const std::vector<tests::Case>& cases) {
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), 0);
  if (is_asked("backwards")) std::reverse(order.begin(), order.end());
  std::stable_partition(order.begin(), order.end(), [&](auto i) { return !cases[i].hidden; });
  return order;
}

using Order = std::vector<std::pair<AskedCheck*, std::size_t>>;

// Asks a new runner what another was asked in the first round, so that by ending itself a program
// doesn't get rid of what it keeps between calls. Returns where it ended, if it did.
std::optional<tests::Outcome> ask_first_round_again(Session& session, const Order& backwards) {
  for (auto question = backwards.rbegin(); question != backwards.rend(); ++question) {
    const auto& [check, i] = *question;
    const auto& first = check->asked.first[i];
    if (!first || first->ended) continue;
    const tests::Outcome outcome = tests::ask(session, check->asked.check, check->asked.cases[i]);
    if (outcome.ended) return outcome;
  }
  return {};
}

// Asks all cases of the part's checks, and once more in reverse order. A check is asked no more
// once the program has ended in it; and no check once it has ended only when asked again, unless it
// was slow: what it keeps between calls made it end, or it got rid of that. Nothing is compared
// meanwhile: tests/parts/checks.hpp says why.
std::map<std::string, AskedCheck> ask_all(Session& session) {
  std::map<std::string, AskedCheck> all;
  Order order;
  for (const tests::Check& check : tests::checks()) {
    AskedCheck& added =
        all.emplace(check.id(), AskedCheck{tests::CheckAnswers(check), {}}).first->second;
    for (const std::size_t i : order_of(added.asked.cases)) order.emplace_back(&added, i);
  }
  for (const bool again : {false, true}) {
    const auto has_ended = [](const auto& question) { return question.first->end.has_value(); };
    bool is_new = again && std::any_of(order.begin(), order.end(), has_ended);
    std::optional<tests::Outcome> ended;
    std::optional<Termination> end;
    for (const auto& [check, i] : order) {
      if (!check->is_asked(again)) continue;
      tests::CheckAnswers& asked = check->asked;
      auto& outcome = (again ? asked.again : asked.first)[i];
      const bool is_over = again && end && end->status != "timed_out";
      if (!is_over) ended = again && is_new ? ask_first_round_again(session, order) : std::nullopt;
      outcome = ended ? *ended : tests::ask(session, asked.check, asked.cases[i]);
      check->end = is_over ? end : session.take_end();
      is_new = check->end.has_value();
      if (is_new) std::tie(end, ended) = std::tie(check->end, outcome);
    }
    std::reverse(order.begin(), order.end());
  }
  return all;
}

// Collects a verdict for each check. A test that fails without reporting a case, or once more than
// it reports, as by an exception, is a fault of the kit.
class Verdicts : public testing::EmptyTestEventListener, public tests::Reporter {
 public:
  explicit Verdicts(const std::map<std::string, AskedCheck>& asked) : asked_(asked) {}
  json checks = json::array();
  std::string kit_failure;
  std::optional<tests::Failure> with_numbers;  // the first failure that has a wrong number
  std::size_t place = 0;                       // of its check

 private:
  const std::map<std::string, AskedCheck>& asked_;
  json reported_;  // of the running check, if it failed
  int failures_ = 0;

  std::string fails(const tests::Failure& failure) override {
    reported_ = json::parse(tests::facts(tests::failed_case(failure)));
    if (!with_numbers && !failure.problem.differences.empty()) {
      with_numbers = failure;
      place = checks.size();
    }
    ++failures_;
    return "";
  }

  void OnTestStart(const testing::TestInfo&) override {
    reported_ = nullptr;
    failures_ = 0;
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    const std::string id = std::string(test.test_suite_name()) + "." + test.name();
    for (int i = 0; i < test.result()->total_part_count(); ++i) {
      const auto& part = test.result()->GetTestPartResult(i);
      if (part.failed() && --failures_ < 0) kit_failure = id + " failed: " + part.message();
    }
    const bool passed = test.result()->Passed();
    const auto& end = asked_.at(id).end;
    if (passed || (end && end->of_no_case))
      reported_ = {{"failure", nullptr}, {"answer", nullptr}, {"smallest", nullptr}};
    checks.push_back({{"id", id},
                      {"passed", passed},
                      {"status", end ? end->status : "graded"},
                      {"ended", end ? facts_of(*end) : json()},
                      {"stack", end ? end->stack : ""},
                      {"failure", reported_.at("failure")},
                      {"answer", reported_.at("answer")},
                      {"smallest", reported_.at("smallest")}});
  }
};

// The answers of a new runner to the public cases. It has been asked nothing else before.
std::vector<tests::Answer> fresh_answers(const std::vector<tests::Case>& questions) {
  const auto fresh = new_session();
  auto got = tests::answers(*fresh, asked.at("part"), questions);
  if (!fresh->kit_failure().empty()) throw std::runtime_error(fresh->kit_failure());
  return got;
}

// Whether to look for known mistakes: not if the program ended while it was tested, as that says
// enough.
bool may_be_a_mistake(const json& checks) {
  const auto graded = [](const json& check) { return check["status"] == "graded"; };
  const auto passed = [](const json& check) -> bool { return check["passed"]; };
  return std::all_of(checks.begin(), checks.end(), graded) &&
         !std::all_of(checks.begin(), checks.end(), passed);
}

void recognise(json& result) {
  const int part = asked.at("part");
  const std::vector<tests::Case> questions = tests::questions(part);
  const auto found = tests::diagnosis(part, questions, fresh_answers(questions));
  result.update(json::parse(tests::facts(found)));
}

// The check in whose cases to look for the simplest one: where it asks several steps at once, the
// part's last that asks one.
const tests::Check& one_question_of(const tests::Check& failed) {
  const auto& all = tests::checks();
  const auto last = std::find_if(all.rbegin(), all.rend(), [](auto& c) { return !c.asks_once; });
  return failed.asks_once ? *last : failed;
}

// Puts a case that is looked for in place of those that are simplest among the public ones.
void find_smallest(Verdicts& verdicts, const std::map<std::string, AskedCheck>& all) {
  for (json& check : verdicts.checks) check["smallest"] = nullptr;
  if (!verdicts.with_numbers || !is_asked("recognise")) return;
  json& check = verdicts.checks[verdicts.place];
  const tests::CheckAnswers& failed = all.at(check["id"]).asked;
  const tests::Check& asks = one_question_of(failed.check);
  const auto found = smallest(new_session, asks, verdicts.with_numbers->asked, failed.cases);
  tests::Failure shown = *verdicts.with_numbers;
  shown.smallest = found;
  check["smallest"] = json::parse(tests::facts(tests::failed_case(shown)))["smallest"];
}

json answers() {
  json all = json::array();
  for (const tests::Answer& answer : fresh_answers(tests::questions(asked.at("part")))) {
    all.push_back(answer.thrown.empty() ? json(answer.numbers) : json(answer.thrown));
  }
  return all;
}

std::string wait() try {
  RunnerProcess runner(command, asked_limits());
  static_cast<void>(runner.receive());
  return "answered";
} catch (const Termination& end) {
  return in_one_line(end);
}

json verdicts() {
  const auto first = new_session();
  std::erase_if(tests::checks(), [](const tests::Check& check) {
    return check.part != "part" + std::to_string(asked.at("part").get<int>());
  });
  const auto all = ask_all(*first);
  first->end();
  if (!first->kit_failure().empty()) throw std::runtime_error(first->kit_failure());

  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  auto* verdicts = new Verdicts(all);
  listeners.Append(verdicts);
  const auto asked_before = [&](const tests::Check& check) { return all.at(check.id()).asked; };
  if (tests::run_checks(*first, *verdicts, asked_before) != 0 && verdicts->checks.empty()) {
    throw std::runtime_error("no test ran");
  }
  if (!verdicts->kit_failure.empty()) throw std::runtime_error(verdicts->kit_failure);

  const bool has_hidden = std::any_of(
      tests::fixture_folders.begin(), tests::fixture_folders.end(),
      [](const std::filesystem::path& folder) { return folder.filename() == "hidden"; });
  if (has_hidden) find_smallest(*verdicts, all);
  json result = {{"checks", verdicts->checks},
                 {"largest_error", tests::largest_error()},
                 {"asked_given", first->has_asked_given()},
                 {"mistakes", json::array()},
                 {"patterns", json::array()}};
  if (is_asked("recognise") && may_be_a_mistake(verdicts->checks)) recognise(result);
  return result;
}

}  // namespace
}  // namespace judge
}  // namespace bounce

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);  // that a runner has ended is noticed by reading from it
  bounce::judge::stay_on_this_cpu();
  int one = 1;
  testing::InitGoogleTest(&one, argv);
  if (argc < 3) throw std::runtime_error("usage: judge JSON COMMAND..., as in its main.cpp");
  bounce::asked = nlohmann::json::parse(argv[1]);
  bounce::command.assign(argv + 2, argv + argc);
  const std::vector<std::string> folders =
      bounce::asked.value("fixtures", std::vector<std::string>());
  bounce::tests::fixture_folders.assign(folders.begin(), folders.end());
  if (bounce::judge::is_asked("watch")) {
    std::cout << bounce::judge::wait() << std::endl;
    return 0;
  }
  const bool answers = bounce::judge::is_asked("answers");
  const auto result = answers ? bounce::judge::answers() : bounce::judge::verdicts();
  // A text may be that of a submission's exception, which may be invalid UTF-8.
  std::cout << result.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  return std::cout ? 0 : 3;
} catch (const std::exception& e) {
  std::cerr << "judge: " << e.what() << std::endl;
  return 3;
}
