"""Attacks that compilers, assemblers, linkers and loaders read."""

from fuzzing.mutation import Random
from fuzzing.nasty_words import FOR_GCC, Piece, in_one_line, new_name, quoted, some_words


def saying(rng: Random, _: list[str]) -> Piece:
    return Piece("".join(_directive(rng) for _ in range(rng.choice((1, 3, 9)))))


def _directive(rng: Random) -> str:
    words, line, name = some_words(rng), in_one_line(rng), new_name(rng, "x")
    return rng.choice(
        [
            *(f"#warning {line}\n", f"#error {line}\n", f"#ident {quoted(words)}\n", f"{line}\n"),
            f"#pragma message({quoted(words)})\n",
            f"#pragma message({quoted(words)})\nint {name} = ;\n",
            f"#pragma GCC {rng.choice(('error', 'warning'))} {quoted(words)}\n",
            f"_Pragma({quoted(f'message({quoted(words)})')})\n",
            f"static_assert(false, {quoted(words)});\n",
            f"static_assert(sizeof(int) == 4, {quoted(words)});\n",
            f"[[deprecated({quoted(words)})]] void {name}() {{}}\n"
            f"void also{name}() {{ {name}(); }}\n",
            f"static int {name}[] = {{ {quoted(words)} }};\n",
            f"#line {rng.choice((0, 1, 7, 2147483647))} {quoted(words)}\nint {name} = ;\n",
            f"#line 3 {quoted(words)}\nint {name}() {{ return missing; }}\n",
            f"#line 3 {quoted(words)}\n",
            f"#include {quoted(line)}\n",
            f"#include <{line}>\n",
            f"#if __has_include({quoted(line)})\n#error there\n#endif\n",
            f"#define EIGEN_ASM_COMMENT(X) __asm__({quoted(f'.print {quoted(words)}')})\n"
            "#include <Eigen/Dense>\n",
            FOR_GCC,
        ]
    )


def assembling(rng: Random, places: list[str]) -> Piece:
    word, place = quoted(some_words(rng)), quoted(rng.choice(places))
    lines = rng.choice(
        [
            *(f".print {word}", f".error {word}", f".warning {word}", ".err", f".ident {word}"),
            *(f".incbin {place}", f".include {place}", f".file {word}", f".file 1 {word} {place}"),
            f".macro m\n.print {word}\n.endm\nm\nm",
            f".rept {rng.choice((3, 300))}\n.print {word}\n.endr",
            f".section {word},{quoted('awx')},@progbits\nnop\n.text",
            f".section .init_array,{quoted('aw')}\n.quad {rng.choice(('0', '1', 'abort'))}\n.text",
            f".globl {word}\n{word}:\n",
            f".symver get,{word}",
            f".comm huge,{rng.choice((1 << 20, 1 << 34, 1 << 50))},8",
            f".zero {rng.choice((1 << 12, 9 << 20))}",
            *(".org 0x100000", ".balign 65536", ".weak main\n.set main,0", ".bundle_align_mode 5"),
            ".pushsection .text.startup\nud2\n.popsection",
            f".ascii {word}\n.err",
            f".linker_option {word}",
            f".section .note.GNU-stack,{quoted('x')},@progbits\n.text",
            f".section .gnu.warning.abort,{quoted('')},@progbits\n.ascii {word}\n.text",
        ]
    )
    quiet = rng.choice(("asm", "__asm__", "asm volatile", "__asm"))
    inside = f"void {new_name(rng, 'assembled')}() {{ {quiet.split()[0]}({quoted(lines)}); }}\n"
    return Piece(rng.choice((f"asm({quoted(lines)});\n", inside)), "")


def burning(rng: Random, _: list[str]) -> Piece:
    """Work for a compiler, of some seconds at most; and never much of it in one submission."""
    depth, x = rng.choice((50, 400, 1500)), new_name(rng, "x")
    tower = f"#define {x}0 1 +\n"
    tower += "".join(f"#define {x}{i} {x}{i - 1} {x}{i - 1}\n" for i in range(1, 14))
    work = f"int s = 0; for (int i = 0; i < {depth * 100}; ++i) s += i % 7; return s;"
    below = f"{x}<N - 1> below; static constexpr int n = {x}<N - 1>::n + 1;"
    return Piece(
        rng.choice(
            [
                f"template <int N> struct {x} {{ {below} }};\n"
                f"template <> struct {x}<0> {{ static constexpr int n = 0; }};\n"
                f"static_assert({x}<{depth}>::n == {depth});\n",
                f"constexpr int {x}() {{ {work} }}\nstatic_assert({x}() > 0);\n",
                f"{tower}static int {x} = {x}13 0;\n",
                f"static int {x} = {'(' * depth}1{')' * depth};\n",
                f"static char {x}[{rng.choice((1 << 10, 9 << 20, 1 << 33))}] = {{1}};\n",
                "".join(f"int {x}{i} = undeclared{i};\n" for i in range(rng.choice((5, 300)))),
                f"template <class T> auto {x}(T t) {{ return {x}(&t); }}\nauto {x}2 = {x}(1);\n",
            ]
        )
    )


SYMBOLS = ["main", "_start", "write", "read", "malloc", "free", "abort", "memcpy", "_exit", "exit"]
SYMBOLS += [
    "__cxa_throw",
    "__assert_fail",
    "__libc_start_main",
    "environ",
    "stdout",
    "sqrt",
    "_init",
]
SYMBOLS += ["_ZN6bounce6runner4sendERKNS_6frames5FrameE", "_ZN6bounce6runner7receiveEv"]
SYMBOLS += [
    "_ZN6bounce9solve_lcpERKN5Eigen6MatrixIdLi4ELi4ELi0ELi4ELi4EEERKNS1_IdLi4ELi1ELi0ELi4ELi1EEE"
]
SYMBOLS += [
    "__asan_default_options",
    "__ubsan_default_options",
    "__asan_on_error",
    "__sanitizer_report",
]


def linking(rng: Random, _: list[str]) -> Piece:
    symbol = rng.choice([*SYMBOLS, some_words(rng)])
    label = f"asm({quoted(symbol)})"
    name = new_name(rng, "taken")
    linkage = rng.choice(("", "__attribute__((weak)) ", "__attribute__((used)) "))
    return Piece(
        rng.choice(
            [
                f'extern "C" {linkage}int {name}() {label};\nint {name}() {{ return 0; }}\n',
                f"{linkage}int number {label};\nint number = 7;\n",
                f'extern "C" int missing() {label};\nint uses() {{ return missing(); }}\n',
                'extern "C" { static int (*resolve())() { return nullptr; }\n'
                f'int chosen() __attribute__((ifunc("resolve"))); }}\nint calls() {{ return chosen(); }}\n',
                'extern "C" int real() { return 1; }\n'
                f'extern "C" int other() {label} __attribute__((alias("real")));\n',
                "namespace bounce { Contact get_contacts(const Vector3&, const Parameters&) "
                "{ return {}; } }\n",
                "namespace bounce { __attribute__((weak)) State step(const Vector3& q, const Vector3& v, "
                "const Parameters&) { return {q, v}; } }\n",
            ]
        )
    )
