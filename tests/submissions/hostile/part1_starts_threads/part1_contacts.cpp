#include <bounce/part1_contacts.hpp>
#include <chrono>
#include <thread>

namespace bounce {

Contact get_contacts(const Vector3&, const Parameters&) {
  for (;;) std::thread([] { std::this_thread::sleep_for(std::chrono::hours(1)); }).detach();
}

}  // namespace bounce
