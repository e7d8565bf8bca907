#include <fstream>
#include <future>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "../check/files.hpp"
#include "../check/words.hpp"
#include "../study/page.hpp"
#include "../study/tables.hpp"
#include "local_server.hpp"
#include "pages.hpp"
#include "paths.hpp"
#include "play.hpp"

namespace bounce::play {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kLongest = 90;  // s that an answer may take; the program ends itself before
constexpr auto kLinking = std::chrono::seconds(10);  // that it may take to link the program

// The program with the student's parts, in a process of its own.
class Program {
 public:
  explicit Program(const fs::path& file)
      : file_(file), folder_(file.parent_path() / "play"), copy_(folder_ / file.filename()) {
    fs::create_directories(folder_);
  }
  ~Program() { end(); }

  // Another number whenever the program was built again.
  long long version() const {
    std::error_code gone;  // while it is being linked
    return static_cast<long long>(fs::last_write_time(file_, gone).time_since_epoch().count());
  }

  // The answer to a question of the page; or why there is none, in the words of ./check. With the
  // version that was asked.
  std::string answer_to(const std::string& question) {
    const std::lock_guard one_at_a_time(mutex_);
    if (runs() && built_ != version()) end();
    const auto give_up = std::chrono::steady_clock::now() + kLinking;
    for (bool is_asked_again = false;;) {
      if (!runs()) start();
      if (std::ifstream in(folder_ / "address"); in >> port_ >> path_) {
        if (const auto answer = post("simulate", question)) return of_version(answer->body);
      }
      const auto ended = ended_.get();
      if (!ended && std::chrono::steady_clock::now() < give_up) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        continue;
      }
      if (!ended) return problem("the program can't be started: it is being built, or is gone");
      const bool is_old = ended->code == 0 && ended->signal == 0;
      if (!is_old || is_asked_again) {
        return problem(check::reason_of(*ended, check::read(folder_ / "printed.txt")) +
                       check::place_of_crash(copy_.string(), folder_ / "stack.txt"));
      }
      is_asked_again = true;
    }
  }

 private:
  std::string of_version(const std::string& answer) const {
    return "{\"version\":" + std::to_string(built_) + "," + answer.substr(1);
  }

  std::string problem(const std::string& sentence) const {
    return of_version(json{{"problem", sentence}}.dump());
  }

  bool runs() const {
    return ended_.valid() && ended_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }

  // Waits until it says where it can be asked, or ends.
  void start() {
    for (const char* name : {"address", "printed.txt", "stack.txt"}) fs::remove(folder_ / name);
    built_ = version();
    take();
    ended_ = std::async(std::launch::async, [this] {
      return check::run({copy_.string(), "--answer", (folder_ / "address").string()},
                        folder_ / "printed.txt", check::Limits::of_a_part);
    });
    while (runs() && !fs::exists(folder_ / "address"))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  // Takes it under a name of its own, so that it can be built meanwhile: a linker writes a new
  // file. No system starts a file that is still being written; a copy of such a file it would
  // start.
  void take() const {
    std::error_code failed;
    fs::remove(copy_, failed);
#ifndef _WIN32
    fs::create_hard_link(file_, copy_, failed);
    if (!failed) return;
#endif
    fs::copy_file(file_, copy_, failed);
  }

  void end() {
    if (!runs()) return;
    post("end", "");
    ended_.wait();
  }

  httplib::Result post(const std::string& name, const std::string& text) const {
    httplib::Client client(LocalServer::kHost, port_);
    client.set_tcp_nodelay(true);
    client.set_read_timeout(kLongest);
    return client.Post(path_ + name, text, "application/json");
  }

  fs::path file_, folder_, copy_;
  std::mutex mutex_;
  std::future<std::optional<check::Termination>> ended_;
  long long built_ = 0;
  int port_ = 0;
  std::string path_;
};

json numbers(const Vector3& of) { return {of(0), of(1), of(2)}; }

// The scenes, and Explore's questions, with the page around them.
std::string page() {
  json data{{"scenes", json::array()}, {"explore", check::read("explore.html")}};
  for (const auto& [name, title, p, start, truth, others] : study::read_scenes(BOUNCE_STUDY)) {
    const json params{{"l", p.l},          {"m", p.m},   {"mu", p.mu},       {"epsilon", p.epsilon},
                      {"g", numbers(p.g)}, {"dt", p.dt}, {"delta", p.delta}, {"T", p.T}};
    data["scenes"].push_back({{"name", name},
                              {"title", title},
                              {"q", numbers(start.q)},
                              {"v", numbers(start.v)},
                              {"params", params}});
  }
  return study::page_with(pages::play, data);
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
  Program program(file);
  LocalServer server;
  server.http.Get(server.path(""), [](const auto&, auto& response) {
    response.set_content(page(), "text/html; charset=utf-8");
  });
  server.http.Get(server.path("version"), [&](const auto&, auto& response) {
    response.set_content(json{{"version", program.version()}}.dump(), "application/json");
  });
  server.http.Post(server.path("simulate"), [&](const auto& request, auto& response) {
    response.set_content(program.answer_to(request.body), "application/json");
  });
  std::cout << "Throw the square at http://" << LocalServer::kHost << ":" << server.port()
            << server.path("") << " in a browser; Ctrl-C ends it." << std::endl;
  return server.http.listen_after_bind() ? 0 : 1;
}

}  // namespace bounce::play
