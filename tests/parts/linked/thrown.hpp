// Adds the part to an exception's text, which alone doesn't say whether it comes from the student's
// program or from the tests.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace bounce::tests {

// Returns what `ask` returns. Turns any exception of it into std::runtime_error, such as "part 1
// threw an exception: oh".
template <class Ask>
auto naming_the_part(const std::string& part, const Ask& ask) {
  try {
    return ask();
  } catch (const std::exception& thrown) {
    throw std::runtime_error(part + " threw an exception: " + thrown.what());
  } catch (const char* text) {
    throw std::runtime_error(part + " threw: " + text);
  } catch (const std::string& text) {
    throw std::runtime_error(part + " threw: " + text);
  } catch (...) {
    throw std::runtime_error(part + " threw something that isn't a std::exception");
  }
}

}  // namespace bounce::tests
