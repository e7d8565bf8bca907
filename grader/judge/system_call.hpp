// What a program asks the system for by a system call, in words.
#pragma once

#include <string>

namespace bounce::judge {

// "a connection (socket)"; "system call 1234" for one that no numerical program comes near.
std::string what_is_asked_by(long system_call);

}  // namespace bounce::judge
