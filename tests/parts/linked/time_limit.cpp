#include "time_limit.hpp"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <future>

namespace bounce::tests {
namespace {

constexpr double kWork = 3;  // s of CPU time, so that a busy machine makes no difference
constexpr auto kWait = std::chrono::seconds(60);
constexpr auto kLook = std::chrono::milliseconds(100);
constexpr int kTooLong = 124, kWaited = 125;  // exit statuses; the command timeout has the first

double worked() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::future<void> watch;
std::promise<void> over;  // ended first, so that the watch ends where the program calls exit

}  // namespace

void limit_time(const std::function<void()>& last_words) {
  over = std::promise<void>();
  watch = std::async(std::launch::async, [last_words, is_over = over.get_future()] {
    const double start = worked();
    const auto end = std::chrono::steady_clock::now() + kWait;
    while (is_over.wait_for(kLook) != std::future_status::ready) {
      const bool has_worked = worked() - start >= kWork;
      if (!has_worked && std::chrono::steady_clock::now() < end) continue;
      last_words();
      std::_Exit(has_worked ? kTooLong : kWaited);
    }
  });
}

void lift_time_limit() {
  over.set_value();
  watch.wait();
}

}  // namespace bounce::tests
