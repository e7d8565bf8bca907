// Given: --play, a page on which the square can be thrown.
#pragma once

#include <filesystem>

namespace bounce::play {

// Serves the page on this machine until this program is ended, and returns its exit status.
// `program` is its own file: when that is built again, the page goes on with the new one.
int serve(const std::filesystem::path& program);

// What `serve` starts: calls the four parts in a process of their own, so that a crash ends nothing
// else. Writes to the file `address` where it is to be asked.
int answer(const std::filesystem::path& address);

}  // namespace bounce::play
