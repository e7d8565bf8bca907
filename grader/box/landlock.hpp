// What is to be seen of the file system where there is no mount namespace.
#pragma once

#include <string>
#include <vector>

namespace bounce::box {

// From here on this process and its children may read and execute what lies beneath `visible`,
// write beneath `writable` and to /dev/null, and touch no other file; nor may they connect to
// anything or send a signal out of the box, where the kernel can forbid that.
// Throws std::runtime_error where the kernel has no Landlock.
void see_only(const std::vector<std::string>& visible, const std::vector<std::string>& writable);

}  // namespace bounce::box
