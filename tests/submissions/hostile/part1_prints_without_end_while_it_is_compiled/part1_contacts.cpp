#include <bounce/part1_contacts.hpp>

asm(".rept 3000000\n.print \"the assembler says this where the compiler's output goes\"\n.endr");

namespace bounce {

Contact get_contacts(const Vector3&, const Parameters&) { return {}; }

}  // namespace bounce
