// A server that only pages of its own can ask.
#pragma once

#include <httplib.h>

#include <random>
#include <stdexcept>
#include <string>

namespace bounce::play {

// On the loopback address, at a port that is free, below a word that nobody else knows. Whatever
// else is asked for isn't found: also by a page of another server that this machine's name was
// given to.
class LocalServer {
 public:
  LocalServer() {
    std::random_device random;
    for (int i = 0; i < 4; ++i) secret_ += std::to_string(random()) + (i < 3 ? "-" : "");
    http.set_socket_options([](socket_t) {});  // the port is nobody else's
    http.set_tcp_nodelay(true);
    http.set_keep_alive_max_count(1'000'000);
    http.set_payload_max_length(10'000);
    http.set_default_headers({{"Cache-Control", "no-store"},
                              {"Referrer-Policy", "no-referrer"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"X-Frame-Options", "DENY"}});
    port_ = http.bind_to_any_port(kHost);
    if (port_ < 0) throw std::runtime_error("no port of this machine is free");
    const std::string host = kHost + (":" + std::to_string(port_));
    http.set_pre_routing_handler(
        [host](const httplib::Request& request, httplib::Response& response) {
          const std::string origin = request.get_header_value("Origin");
          const bool is_own = request.get_header_value("Host") == host;
          if (is_own && (origin.empty() || origin == "http://" + host))
            return httplib::Server::HandlerResponse::Unhandled;
          response.status = 404;
          return httplib::Server::HandlerResponse::Handled;
        });
  }

  int port() const { return port_; }
  std::string path(const std::string& name) const { return "/" + secret_ + "/" + name; }

  static constexpr const char* kHost = "127.0.0.1";
  httplib::Server http;

 private:
  std::string secret_;
  int port_ = -1;
};

}  // namespace bounce::play
