#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "../drawing.hpp"
#include "crash.hpp"
#include "linked/time_limit.hpp"
#include "local_server.hpp"
#include "play.hpp"

namespace bounce::play {
namespace {

using nlohmann::json;

constexpr int kMostColumns = 100'000;
constexpr auto kAge = std::chrono::seconds(20);  // well below the limits of a part

Vector3 vector(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

Parameters parameters(const json& from) {
  Parameters params{from.at("l"),         from.at("m"),  from.at("mu"),    from.at("epsilon"),
                    vector(from.at("g")), from.at("dt"), from.at("delta"), from.at("T")};
  if (params.T < 1 || params.T > kMostColumns)
    throw std::invalid_argument("these are too many steps: choose a larger dt");
  return params;
}

// The motion as the page draws it, or what there is to say in its place.
std::string answer_to(const std::string& question) {
  try {
    const json asked = json::parse(question);
    const Parameters params = parameters(asked.at("params"));
    return data_of({simulated({vector(asked.at("q")), vector(asked.at("v"))}, params), params});
  } catch (const json::exception&) {
    return json{{"problem", "this question isn't understood"}}.dump();
  } catch (const std::exception& error) {
    return json{{"problem", error.what()}}.dump();
  }
}

}  // namespace

int answer(const std::filesystem::path& address) {
  const auto folder = address.parent_path();
  runner::report_crashes((folder / "stack.txt").string().c_str());
  LocalServer server;
  server.http.new_task_queue = [] { return new httplib::ThreadPool(1); };
  server.http.Post(server.path("simulate"), [](const auto& request, auto& response) {
    tests::limit_time([] {});
    response.set_content(answer_to(request.body), "application/json");
    tests::lift_time_limit();
  });
  server.http.Post(server.path("end"), [&](const auto&, auto&) { server.http.stop(); });
  const auto part = folder / "address.part";
  std::ofstream(part) << "";
  std::filesystem::permissions(
      part, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  std::ofstream(part) << server.port() << ' ' << server.path("");
  std::filesystem::rename(part, address);
  // It ends by and by, also where nobody is left to end it; the next question starts another.
  std::thread([&server] {
    std::this_thread::sleep_for(kAge);
    server.http.stop();
  }).detach();
  server.http.listen_after_bind();
  return 0;
}

}  // namespace bounce::play
