// Ends processes that outlive their parent. A box's processes end with its first one; but a box
// that is ended while it is set up can leave processes behind.
#pragma once

#include <sys/types.h>

#include <set>

namespace bounce::judge {

// From here on, orphans among this process's descendants become its children.
void adopt_orphans();

// Ends and waits for every child of this process except `started`.
void end_orphans(const std::set<pid_t>& started);

}  // namespace bounce::judge
