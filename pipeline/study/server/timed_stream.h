#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

#include <boost/asio/error.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <poll.h>

namespace mien::pipeline {

/// A client's socket as a synchronous stream for Boost.Asio, with a deadline. Waiting for the
/// client ends with timed_out at the deadline. Waiting for its data also ends when the server
/// stops, with operation_aborted.
class TimedStream {
 public:
  using ErrorCode = boost::system::error_code;

  TimedStream(boost::asio::ip::tcp::socket socket, const std::atomic<bool>& is_stopping)
      : socket_(std::move(socket)), is_stopping_(is_stopping) {
    socket_.non_blocking(true);
  }

  /// Sets the deadline for all operations until the next call.
  void expires_after(std::chrono::milliseconds time) { deadline_ = Clock::now() + time; }

  std::size_t read_some(const auto& buffers, ErrorCode& error) {
    std::size_t count = 0;
    do count = socket_.read_some(buffers, error);
    while (error == boost::asio::error::would_block && wait(POLLIN, error));
    return count;
  }

  std::size_t write_some(const auto& buffers, ErrorCode& error) {
    std::size_t count = 0;
    do count = socket_.write_some(buffers, error);
    while (error == boost::asio::error::would_block && wait(POLLOUT, error));
    return count;
  }

  boost::asio::ip::tcp::socket& socket() { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// Waits until the socket is ready, but at most 200 ms; the caller then tries again. Returns
  /// false if the caller must give up, with the reason in `error`: an error of the operation, the
  /// deadline, or, when reading, that the server is stopping.
  bool wait(short event, ErrorCode& error) {
    constexpr std::chrono::milliseconds poll_interval{200};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now());
    if (left.count() <= 0) error = boost::asio::error::timed_out;
    if (event == POLLIN && is_stopping_) error = boost::asio::error::operation_aborted;
    if (error != boost::asio::error::would_block) return false;
    pollfd polled_socket{socket_.native_handle(), event, 0};
    poll(&polled_socket, 1, static_cast<int>(std::min(left, poll_interval).count()));
    return true;
  }

  boost::asio::ip::tcp::socket socket_;
  const std::atomic<bool>& is_stopping_;
  Clock::time_point deadline_;
};

}  // namespace mien::pipeline
