"""Shows matrices of Eigen as rows of numbers, in gdb and lldb:

gdb -x given/debug/eigen.py --args build/debug/part2_lcp_test --debug
(lldb) command script import given/debug/eigen.py
"""

import re
import struct

MATRIX = r"^(?:const )?Eigen::Matrix<double, *(-?\d+), *(-?\d+), *(\d+)"


def shown(name, size, memory):
    """Of the type's name, what gives the number of rows or columns where it isn't fixed, and what
    reads this many bytes."""
    rows, columns, options = map(int, re.match(MATRIX, name).groups())
    rows = size("m_rows") if rows < 0 else rows
    columns = size("m_cols") if columns < 0 else columns
    numbers = struct.unpack(f"{rows * columns}d", memory(8 * rows * columns))
    by_row = [numbers[i * columns : (i + 1) * columns] for i in range(rows)]
    lines = by_row if options & 1 else [numbers[i::rows] for i in range(rows)]
    text = "\n".join("  " + " ".join(f"{x:12.6g}" for x in line) for line in lines)
    return f"{rows}x{columns}\n{text}"


def for_gdb():
    class Printer:
        def __init__(self, value, name):
            self.value, self.name = value, name

        def to_string(self):
            storage = self.value["m_storage"]
            data = storage["m_data"]
            is_fixed = data.type.strip_typedefs().code != gdb.TYPE_CODE_PTR
            at = int(data.address if is_fixed else data)
            read = gdb.selected_inferior().read_memory
            return shown(self.name, lambda n: int(storage[n]), lambda n: bytes(read(at, n)))

    def find(value):
        name = str(value.type.strip_typedefs().unqualified())
        return Printer(value, name) if re.match(MATRIX, name) else None

    gdb.pretty_printers.append(find)


def summary(value, _):
    value = value.GetNonSyntheticValue()
    storage = value.GetChildMemberWithName("m_storage")
    data = storage.GetChildMemberWithName("m_data")
    at = data.GetValueAsUnsigned() if data.GetType().IsPointerType() else data.GetLoadAddress()
    read = value.GetProcess().ReadMemory
    return shown(
        value.GetType().GetCanonicalType().GetName(),
        lambda n: storage.GetChildMemberWithName(n).GetValueAsSigned(),
        lambda n: bytes(read(at, n, lldb.SBError())) if n else b"",
    )


def __lldb_init_module(debugger, _):
    debugger.HandleCommand(
        f"type summary add -x '^Eigen::Matrix<double,' --python-function {__name__}.summary"
    )


try:
    import gdb
except ImportError:
    import lldb
else:
    for_gdb()
