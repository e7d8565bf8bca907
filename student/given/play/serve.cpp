// --play: serves the page on which the square can be thrown.
#include <chrono>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <stdexcept>
#include <thread>

#include "../check/files.hpp"
#include "../check/words.hpp"
#include "../drawing.hpp"
#include "../study/page.hpp"
#include "../study/tables.hpp"
#include "paths.hpp"

// Behind Eigen, whose names it defines as macros.
#include <httplib.h>

namespace bounce {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kHost = "127.0.0.1";
// How often, and with which pause, a program is started that is just being linked.
constexpr int kTries = 500;
constexpr auto kPause = std::chrono::milliseconds(20);
// Requests that others on this machine begin and don't end hold a thread for a second each.
constexpr std::size_t kThreads = 32;

// Another number whenever the program was built again.
long long version_of(const fs::path& program) {
  std::error_code gone;  // while it is being linked
  return static_cast<long long>(fs::last_write_time(program, gone).time_since_epoch().count());
}

// The answer to a question of the page by the program with the student's parts (answer.cpp), which
// is started for each question; or why there is none, in the words of ./check.
std::string answer_to(const std::string& question, const fs::path& program,
                      const fs::path& folder) {
  static std::mutex one_at_a_time;
  const std::lock_guard alone(one_at_a_time);
  const fs::path printed = folder / "printed.txt", stack = folder / "stack.txt";
  const fs::path answer = folder / "answer.json";
  for (const fs::path& file : {printed, stack, answer}) fs::remove(file);
  check::write(folder / "question.json", question);
  std::optional<int> ended;
  for (int tries = 0; !ended && tries < kTries; ++tries) {
    if (tries > 0) std::this_thread::sleep_for(kPause);
    ended = check::run({program.string(), folder.string()}, printed, check::Limits::of_a_part);
  }
  if (const std::string text = check::read(answer); !text.empty()) return text;
  const std::string cause = check::cause_in(stack);
  const std::string problem = ended ? check::reason_of(*ended, check::read(printed), cause) +
                                          check::place_of_crash(program.string(), stack)
                                    : "the program can't be started: it is being built, or is gone";
  return json{{"problem", problem}}.dump();
}

// Where nobody else on this machine finds it.
std::string secret_path() {
  std::random_device random;
  std::string path = "/";
  for (int i = 0; i < 4; ++i) path += std::to_string(random()) + (i < 3 ? "-" : "/");
  return path;
}

// Binds the server to the loopback address, at a port that is free, and returns this. What isn't
// asked for by its own page isn't found: also by a page of another server that this machine's name
// was given to.
int bind(httplib::Server& server) {
  server.set_socket_options([](socket_t) {});  // the port is nobody else's
  server.set_tcp_nodelay(true);
  server.set_keep_alive_max_count(1'000'000);
  server.set_payload_max_length(10'000);
  server.set_read_timeout(1);
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  server.set_default_headers({{"Cache-Control", "no-store"},
                              {"Referrer-Policy", "no-referrer"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"X-Frame-Options", "DENY"}});
  const int port = server.bind_to_any_port(kHost);
  if (port < 0) throw std::runtime_error("no port of this machine is free");
  const std::string host = kHost + (":" + std::to_string(port));
  server.set_pre_routing_handler(
      [host](const httplib::Request& request, httplib::Response& response) {
        const std::string origin = request.get_header_value("Origin");
        const bool is_own = request.get_header_value("Host") == host;
        const bool is_whole = !request.has_header("Transfer-Encoding");  // with a length before it
        if (is_own && is_whole && (origin.empty() || origin == "http://" + host))
          return httplib::Server::HandlerResponse::Unhandled;
        response.status = is_whole ? 404 : 411;
        return httplib::Server::HandlerResponse::Handled;
      });
  return port;
}

#ifdef _WIN32
// The file of a program that runs can't be written, but it can be renamed.
void make_way(const fs::path& program) {
  fs::path running = program;
  running.replace_extension(".running.exe");
  std::error_code in_use;  // by another page
  fs::remove(running, in_use);
  fs::rename(program, running, in_use);
  if (!in_use) fs::copy_file(running, program);
}
#endif

}  // namespace

int serve(const fs::path& given) {
  const fs::path there = fs::absolute(given);
  fs::current_path(fs::path(BOUNCE_HOME));     // where ./check runs, whose words these are
  const fs::path file = fs::proximate(there);  // without what a system can't write of the path
#ifdef _WIN32
  make_way(file);
#endif
  const fs::path program = file.parent_path() / ("answer" + file.extension().string());
  const fs::path folder = file.parent_path() / "play";
  fs::create_directories(folder);
  httplib::Server server;
  const int port = bind(server);
  const std::string path = secret_path();
  server.Get(path, [](const auto&, auto& response) {
    const json data{{"scenes", study::read_json("fixtures/study.json")}};
    response.set_content(study::page_with("play.html", data), "text/html; charset=utf-8");
  });
  server.Get(path + "version", [&](const auto&, auto& response) {
    response.set_content(json{{"version", version_of(program)}}.dump(), "application/json");
  });
  server.Post(path + "simulate", [&](const auto& request, auto& response) {
    response.set_content(answer_to(request.body, program, folder), "application/json");
  });
  std::cout << "Throw the square at http://" << kHost << ":" << port << path
            << " in a browser; Ctrl-C ends it." << std::endl;
  return server.listen_after_bind() ? 0 : 1;
}

}  // namespace bounce
