// What a part throws, in words that name the part: an exception's text alone doesn't say whether a
// student's program or the tests said it.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace bounce::tests {

// What `ask` returns. Throws std::runtime_error, as "part 1 threw an exception: oh", for whatever
// it throws.
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
