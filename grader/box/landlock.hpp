// Restricts access to the file system if there is no mount namespace.
#pragma once

#include <string>
#include <vector>

namespace bounce::box {

// From here on, this process and its children may read and execute files beneath `visible`, write
// beneath `writable` (if it isn't empty) and to /dev/null, and access no other file. If the kernel
// can forbid it, they also can't connect to anything or send signals out of the box. Throws
// std::runtime_error if the kernel has no Landlock.
void see_only(const std::vector<std::string>& visible, const std::string& writable);

}  // namespace bounce::box
