#pragma once

#include <chrono>
#include <string>

#include <httplib.h>

namespace mien::pipeline {

/// A socket as the library wants it: what was read of a request already, and where its answer goes.
/// Methods that only some versions of the library know are not marked as overriding.
class HttpConnection : public httplib::Stream {
 public:
  HttpConnection(int socket, std::string head, std::chrono::milliseconds answer_time);

  bool is_readable() const override { return at_ < head_.size(); }
  bool is_writable() const override { return true; }
  ssize_t read(char* bytes, size_t size) override;
  ssize_t write(const char* bytes, size_t size) override;
  void get_remote_ip_and_port(std::string& address, int& port) const override;
  void get_local_ip_and_port(std::string& address, int& port) const override;
  socket_t socket() const override { return socket_; }
  using httplib::Stream::write;

 private:
  using Clock = std::chrono::steady_clock;

  int socket_;
  std::string head_;
  std::size_t at_ = 0;
  Clock::time_point deadline_;
};

/// The address of the client at a socket: "127.0.0.1".
std::string client_address(int socket);

/// Sends a short text without waiting for anything.
void send_now(int socket, const std::string& text);

/// Closes the way out and takes for a moment what still comes: a client that is refused while it
/// sends would not get to read why.
void take_the_rest(int socket);

}  // namespace mien::pipeline
