#include "channel.hpp"

#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace bounce::runner {
namespace {

void write_all(const void* data, std::size_t size) {
  const char* from = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t n = ::write(frames::kAnswers, from, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw ChannelClosed();
    from += n;
    size -= static_cast<std::size_t>(n);
  }
}

}  // namespace

frames::Frame receive() {
  frames::Frame frame;
  char* to = reinterpret_cast<char*>(&frame);
  for (std::size_t got = 0; got < sizeof frame;) {
    const ssize_t n = ::read(frames::kQuestions, to + got, sizeof frame - got);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw ChannelClosed();
    got += static_cast<std::size_t>(n);
  }
  return frame;
}

void send(const frames::Frame& frame) { write_all(&frame, sizeof frame); }

void send(const Eigen::Matrix3Xd& columns) {
  write_all(columns.data(), sizeof(double) * static_cast<std::size_t>(columns.size()));
}

frames::Frame call_back(frames::Frame callback) {
  callback.kind = frames::Kind::callback;
  send(callback);
  const frames::Frame reply = receive();
  if (reply.kind != frames::Kind::answer) throw std::runtime_error(frames::text(reply));
  return reply;
}

}  // namespace bounce::runner
