#include "privileges.hpp"

#include <grp.h>
#include <unistd.h>

#include "require.hpp"

namespace bounce::box {

void give_up_privileges(uid_t user) {
  if (::geteuid() != 0) return;
  require(::setgroups(0, nullptr), "leaving all groups");
  require(::setresgid(user, user, user), "changing the group");
  require(::setresuid(user, user, user), "changing the user");
  if (::setuid(0) == 0) throw std::runtime_error("root could be had again");
}

}  // namespace bounce::box
