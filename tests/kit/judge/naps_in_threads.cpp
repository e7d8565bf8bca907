// A runner that answers nothing: it starts threads that end at once, and sleeps in between.
#include <chrono>
#include <thread>

int main() {
  for (;;) {
    std::thread([] {}).join();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}
