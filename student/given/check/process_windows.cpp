#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <io.h>
#include <windows.h>

#include <csignal>
#include <iostream>

#include "files.hpp"
#include "process.hpp"

namespace bounce::check {
namespace {

constexpr SIZE_T kMemory = SIZE_T{4} << 30;  // bytes
constexpr DWORD kLongestRun = 120'000;       // ms; each check ends sooner, a constructor may not
constexpr UINT kStopped = 124;               // as a test program's where a check takes too long

int termination_of(DWORD code) {
  switch (code) {
    case EXCEPTION_ACCESS_VIOLATION:
    case EXCEPTION_STACK_OVERFLOW:
    case EXCEPTION_ARRAY_BOUNDS_EXCEEDED:
      return -SIGSEGV;
    case EXCEPTION_INT_DIVIDE_BY_ZERO:
    case EXCEPTION_FLT_DIVIDE_BY_ZERO:
      return -SIGFPE;
    case 3:  // abort(), in Microsoft's library
    case 0xC0000409:
      return -SIGABRT;
    default:
      return code < 0xff ? static_cast<int>(code) : 0xff;  // the largest of other systems
  }
}

}  // namespace

std::optional<int> run(const std::vector<std::string>& command, const std::filesystem::path& output,
                       Limits limits) {
  // No word holds a quotation mark, which no file's name can hold here, or ends in a backslash.
  std::string line;
  for (const std::string& word : command) line += "\"" + word + "\" ";
  SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  const HANDLE out =
      CreateFileW(output.wstring().c_str(), FILE_APPEND_DATA, FILE_SHARE_READ | FILE_SHARE_WRITE,
                  &inherited, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
  const HANDLE in = CreateFileW(L"NUL", GENERIC_READ, FILE_SHARE_READ, &inherited, OPEN_EXISTING,
                                FILE_ATTRIBUTE_NORMAL, nullptr);
  STARTUPINFOA start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdInput = in;
  start.hStdOutput = start.hStdError = out;
  PROCESS_INFORMATION process{};
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);  // no window when it crashes
  const BOOL started = CreateProcessA(nullptr, line.data(), nullptr, nullptr, TRUE,
                                      CREATE_SUSPENDED, nullptr, nullptr, &start, &process);
  CloseHandle(in);
  CloseHandle(out);
  if (!started) return std::nullopt;
  const HANDLE job = CreateJobObjectA(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION most{};
  most.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (limits == Limits::of_a_part) {
    most.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_MEMORY;
    most.ProcessMemoryLimit = kMemory;
  }
  SetInformationJobObject(job, JobObjectExtendedLimitInformation, &most, sizeof most);
  AssignProcessToJobObject(job, process.hProcess);
  ResumeThread(process.hThread);
  const DWORD longest = limits == Limits::of_a_part ? kLongestRun : INFINITE;
  if (WaitForSingleObject(process.hProcess, longest) == WAIT_TIMEOUT) {
    TerminateJobObject(job, kStopped);
    WaitForSingleObject(process.hProcess, INFINITE);
  }
  DWORD code = 0;
  GetExitCodeProcess(process.hProcess, &code);
  CloseHandle(process.hThread);
  CloseHandle(process.hProcess);
  CloseHandle(job);
  return termination_of(code);
}

std::shared_ptr<void> lock(const std::filesystem::path& file) {
  const HANDLE handle =
      CreateFileW(file.wstring().c_str(), GENERIC_READ | GENERIC_WRITE,
                  FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr, OPEN_ALWAYS, 0, nullptr);
  if (handle == INVALID_HANDLE_VALUE) throw Failure(kReadOnly);
  OVERLAPPED at{};
  if (!LockFileEx(handle, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &at)) {
    std::cerr << kWaits << std::endl;
    LockFileEx(handle, LOCKFILE_EXCLUSIVE_LOCK, 0, 1, 0, &at);
  }
  return {handle, CloseHandle};
}

bool is_terminal() {
  if (!_isatty(_fileno(stdout))) return false;
  SetConsoleOutputCP(CP_UTF8);
  const HANDLE out = GetStdHandle(STD_OUTPUT_HANDLE);
  DWORD mode = 0;
  return GetConsoleMode(out, &mode) && SetConsoleMode(out, mode | 0x4);  // it understands colours
}

}  // namespace bounce::check
