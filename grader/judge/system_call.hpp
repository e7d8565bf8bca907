// Describes a system call in words.
#pragma once

#include <string>

namespace bounce::judge {

// As "a connection (socket)"; "system call 1234" for one without a description.
std::string what_is_asked_by(long system_call);

}  // namespace bounce::judge
