#include "pipeline/study/server/http_connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

namespace mien::pipeline {

namespace {

using SocketName = int (*)(int, sockaddr*, socklen_t*);

void read_address(int socket, SocketName name, std::string& address, int& port) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  port = 0;
  address.clear();
  if (name(socket, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return;
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> service{};
  if (getnameinfo(reinterpret_cast<sockaddr*>(&storage), size, host.data(), host.size(),
                  service.data(), service.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return;
  address = host.data();
  port = std::atoi(service.data());
}

int remote_name(int socket, sockaddr* name, socklen_t* size) {
  return getpeername(socket, name, size);
}

int local_name(int socket, sockaddr* name, socklen_t* size) {
  return getsockname(socket, name, size);
}

}  // namespace

HttpConnection::HttpConnection(int socket, std::string head, std::chrono::milliseconds answer_time)
    : socket_(socket), head_(std::move(head)), deadline_(Clock::now() + answer_time) {}

ssize_t HttpConnection::read(char* bytes, size_t size) {
  const std::size_t count = std::min(size, head_.size() - at_);
  std::memcpy(bytes, head_.data() + at_, count);
  at_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t HttpConnection::write(const char* bytes, size_t size) {
  while (true) {
    const ssize_t count = send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0) return count;
    if (errno != EAGAIN && errno != EINTR) return -1;
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now());
    if (left.count() <= 0) return -1;
    pollfd watched{socket_, POLLOUT, 0};
    if (poll(&watched, 1, static_cast<int>(left.count())) < 0 && errno != EINTR) return -1;
  }
}

void HttpConnection::get_remote_ip_and_port(std::string& address, int& port) const {
  read_address(socket_, remote_name, address, port);
}

void HttpConnection::get_local_ip_and_port(std::string& address, int& port) const {
  read_address(socket_, local_name, address, port);
}

std::string client_address(int socket) {
  std::string address;
  int port = 0;
  read_address(socket, remote_name, address, port);
  return address;
}

void send_now(int socket, const std::string& text) {
  send(socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

void take_the_rest(int socket) {
  constexpr int most_pieces = 64;
  constexpr int patience_ms = 200;
  shutdown(socket, SHUT_WR);
  std::array<char, 4096> piece;
  for (int count = 0; count < most_pieces; ++count) {
    pollfd watched{socket, POLLIN, 0};
    if (poll(&watched, 1, patience_ms) <= 0) return;
    if (recv(socket, piece.data(), piece.size(), MSG_DONTWAIT) <= 0) return;
  }
}

}  // namespace mien::pipeline
