// Drops privileges.
#pragma once

#include <sys/types.h>

namespace bounce::box {

// If run by root, becomes `user` for good; otherwise changes nothing. Throws std::runtime_error if
// it fails.
void give_up_privileges(uid_t user);

}  // namespace bounce::box
