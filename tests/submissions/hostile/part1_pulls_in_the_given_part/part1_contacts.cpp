#include <bounce/part1_contacts.hpp>

#pragma comment(lib, "given_part1.o")

namespace bounce {

}  // namespace bounce
