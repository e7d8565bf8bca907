#pragma once
// A channel between two boxes: sysinfo's `procs` counts the threads of the whole machine. Both
// sides send a packet of 14 nibbles at once, in slots of the common clock; a nibble is as many
// parked threads. Packet: header, 10 nibbles of a number, 3 of a checksum.
#include <linux/futex.h>
#include <pthread.h>
#include <sched.h>
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <time.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
namespace chan {
#ifndef SLOT
#define SLOT 450000
#endif
static constexpr long kSlot = SLOT;  // ns
static constexpr int kNibbles = 14, kSlots = kNibbles + 2;
using Packet = std::array<int, kNibbles>;
static inline long now() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1000000000L + t.tv_nsec;
}
static inline double cpu() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}
static inline int threads() {
  struct sysinfo s;
  sysinfo(&s);
  return s.procs;
}
static inline void until(long t) {
  if (t - now() > 130000) {
    const long u = t - 80000;
    timespec s{u / 1000000000L, u % 1000000000L};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &s, nullptr);
  }
  while (now() < t) sched_yield();
}
static std::atomic<int> flags[8192];
static unsigned fresh = 0;
static unsigned which[16];
static int level = 0;
static void* parked(void* p) {
  auto* f = static_cast<std::atomic<int>*>(p);
  while (!f->load()) syscall(SYS_futex, f, FUTEX_WAIT_PRIVATE, 0, nullptr);
  return nullptr;
}
static inline void set(int to) {
  while (level < to) {
    const unsigned f = which[level] = fresh++ % 8192;
    flags[f] = 0;
    pthread_attr_t a;
    pthread_attr_init(&a);
    pthread_attr_setstacksize(&a, 32768);
    pthread_attr_setdetachstate(&a, PTHREAD_CREATE_DETACHED);
    pthread_t t;
    if (pthread_create(&t, &a, parked, &flags[f])) break;
    ++level;
  }
  while (level > to) {
    auto& f = flags[which[--level]];
    f = 1;
    syscall(SYS_futex, &f, FUTEX_WAKE_PRIVATE, 1);
  }
}
static inline int sum(const Packet& n) {
  uint32_t c = 0x1d0f;
  for (int i = 0; i < 11; ++i) c = (c * 31 + n[i] + 7) ^ (c >> 9);
  return c & 0xfff;
}
static inline Packet packet(int header, double x) {
  Packet p{};
  p[0] = header;
  const int64_t v = llround(x * 1e10);
  for (int k = 0; k < 10; ++k) p[1 + k] = (v >> (4 * k)) & 15;
  const int c = sum(p);
  for (int k = 0; k < 3; ++k) p[11 + k] = (c >> (4 * k)) & 15;
  return p;
}
static inline bool number(const Packet& p, double& x) {
  int c = 0;
  for (int k = 0; k < 3; ++k) c |= p[11 + k] << (4 * k);
  if (c != sum(p)) return false;
  int64_t v = 0;
  for (int k = 0; k < 10; ++k) v |= int64_t(p[1 + k]) << (4 * k);
  x = ((v << 24) >> 24) * 1e-10;
  return true;
}
static inline int quiet_threads() {
  int s[3];
  for (int& x : s) x = threads();
  std::sort(s, s + 3);
  return s[1] - level;
}
// Sends one packet (or silence) and hears one, in the next frame of the clock.
static inline Packet exchange(const Packet* out) {
  const long frame = kSlots * kSlot, begin = (now() / frame + 1) * frame;
  Packet in{};
  set(0);
  until(begin + kSlot * 3 / 4);
  int before = quiet_threads();
  for (int i = 0; i < kNibbles; ++i) {
    until(begin + (i + 1) * kSlot);
    set(out ? (*out)[i] : 0);
    until(begin + (i + 1) * kSlot + kSlot * 3 / 4);
    in[i] = (quiet_threads() - before) & 15;
  }
  until(begin + (kNibbles + 1) * kSlot);
  set(0);
  return in;
}
}  // namespace chan
