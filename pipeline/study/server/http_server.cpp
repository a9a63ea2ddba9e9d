#include "pipeline/study/server/http_server.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/version.hpp>
#include <fcntl.h>
#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/study/server/timed_stream.h"

namespace mien::pipeline {

namespace {

namespace net = boost::asio;
namespace http = boost::beast::http;
using net::ip::tcp;

constexpr int requests_a_connection = 1000;

/// Content-Security-Policy: what a page may load and run.
std::string content_policy(bool webassembly) {
  return std::string("default-src 'none'; script-src 'self'") +
         (webassembly ? " 'wasm-unsafe-eval'" : "") +
         "; style-src 'self'; img-src 'self' data: blob:; media-src 'self' blob:; connect-src "
         "'self' blob:; font-src 'self'; worker-src 'self' blob:; base-uri 'none'; "
         "form-action 'none'; frame-ancestors 'none'";
}

/// Security headers of every response, beside its policy.
constexpr std::array<std::pair<const char*, const char*>, 7> security_headers = {{
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"X-Robots-Tag", "noindex, nofollow"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cache-Control", "no-store"},
}};

HttpResponse refusal_of(int status, bool lacks_host) {
  if (lacks_host)
    return http_refusal(status, "host", "the request has no Host header", "send Host");
  switch (status) {
    case 408:
      return http_refusal(status, "slow", "the request took too long", "send it again");
    case 411:
      return http_refusal(status, "length", "the length is missing", "send Content-Length");
    case 413:
      return http_refusal(status, "long", "the request is too long", "send less");
    case 415:
      return http_refusal(status, "type", "the request is compressed", "send it uncompressed");
    case 429:
      return http_refusal(status, "often", "too many requests", "wait a little");
    case 431:
      return http_refusal(status, "long", "the headers are too long", "send less");
    case 503:
      return http_refusal(status, "busy", "too many connections", "wait a little");
    default:
      return http_refusal(status, "malformed", "this is not a valid request",
                          "send it as HTTP/1.1");
  }
}

/// Status line and headers.
std::string head_text(const HttpResponse& response, std::uint64_t length, bool is_persistent) {
  http::response_header<> head;
  head.result(static_cast<unsigned>(response.status));
  head.set(http::field::connection, is_persistent ? "keep-alive" : "close");
  if (response.status == 503) head.set(http::field::retry_after, "2");
  head.set("Content-Security-Policy", content_policy(response.webassembly));
  for (const auto& [name, value] : security_headers) head.set(name, value);
  for (const auto& [name, value] : response.headers) head.set(name, value);
  head.set(http::field::content_type, response.type);
  head.set(http::field::content_length, std::to_string(length));
  std::ostringstream text;
  text << head;
  return text.str();
}

/// Sends a part of a file, piece by piece.
void send_part(TimedStream& client, const FilePart& part, TimedStream::ErrorCode& error) {
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(part.offset));
  std::vector<char> piece(65536);
  for (std::uint64_t left = part.length; left > 0 && !error; left -= piece.size()) {
    piece.resize(std::min<std::uint64_t>(left, piece.size()));
    if (!file.read(piece.data(), static_cast<std::streamsize>(piece.size())))
      error = net::error::eof;
    else
      net::write(client, net::buffer(piece), error);
  }
}

/// False when the client did not get all of it.
bool send_response(TimedStream& client, const HttpResponse& response, bool is_persistent,
                   bool only_head = false) {
  TimedStream::ErrorCode error;
  const std::uint64_t length = response.part ? response.part->length : response.body.size();
  const std::string head = head_text(response, length, is_persistent);
  const bool has_text = !response.part && !only_head;
  const std::array<net::const_buffer, 2> text = {
      net::buffer(head), has_text ? net::buffer(response.body) : net::const_buffer()};
  net::write(client, text, error);
  if (response.part && !only_head && !error) send_part(client, *response.part, error);
  return !error;
}

/// Shuts down sending and drains the input for a moment. Otherwise a client that is refused while
/// it still sends would get a connection reset instead of the response.
void drain_input(TimedStream& client) {
  TimedStream::ErrorCode error;
  client.socket().shutdown(tcp::socket::shutdown_send, error);
  client.expires_after(std::chrono::seconds(1));
  std::vector<char> rest(std::size_t{256} << 10U);
  net::read(client, net::buffer(rest), error);
}

/// Keeps child processes from inheriting a socket.
void keep_from_children(int socket) { fcntl(socket, F_SETFD, FD_CLOEXEC); }

}  // namespace

std::string http_library() {
  return fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                     BOOST_VERSION % 100);
}

class HttpServer::Listener {
 public:
  Listener(const HttpSettings& settings, HttpHandler answer, HttpFailureHandler failure)
      : settings_(settings),
        requests_(settings.requests),
        answer_(std::move(answer)),
        failure_(std::move(failure)),
        acceptor_(bound()),
        connections_(static_cast<std::size_t>(settings.connections)),
        thread_([this] { accept_connections(); }) {}

  ~Listener() {
    is_stopping_ = true;
    shutdown(acceptor_.native_handle(), SHUT_RDWR);  // wakes the thread that accepts
    thread_.join();
    connections_.join();
  }

  int port() const { return acceptor_.local_endpoint().port(); }

 private:
  tcp::acceptor bound() {
    std::string reason = "no such address here";
    TimedStream::ErrorCode error;
    for (const auto& address : tcp::resolver(context_).resolve(
             settings_.listen, std::to_string(settings_.port), tcp::resolver::passive, error)) {
      try {
        tcp::acceptor acceptor(context_, address);
        keep_from_children(acceptor.native_handle());
        return acceptor;
      } catch (const boost::system::system_error& failed) {
        reason = failed.code().message();
      }
    }
    throw Error({settings_.listen + ":" + std::to_string(settings_.port)},
                "cannot listen on this address: " + reason,
                "choose another port with --port (0: any that is free) or address with --listen");
  }

  /// Accepts connections, each served by a thread of its own; beyond the limit they are refused.
  void accept_connections() {
    while (!is_stopping_) {
      TimedStream::ErrorCode error;
      tcp::socket socket = acceptor_.accept(error);
      if (error) {  // too many open files, for example
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        continue;
      }
      keep_from_children(socket.native_handle());
      TimedStream client(std::move(socket), is_stopping_);
      if (open_ >= settings_.connections) {
        send_response(client, refusal_of(503, false), false);
        continue;
      }
      ++open_;
      net::post(connections_, [this, client = std::move(client)]() mutable {
        answer_requests(TimedStream(std::move(client)));
        --open_;
      });
    }
  }

  void answer_requests(TimedStream client) {
    TimedStream::ErrorCode error;
    client.socket().set_option(tcp::no_delay(true), error);
    const std::string address = client.socket().remote_endpoint(error).address().to_string();
    std::string received;
    for (int count = 1; count <= requests_a_connection; ++count) {
      if (!has_more(client, received)) return;
      RequestHead head = read_head(client, received);
      HttpRequest request{.method = head.method, .headers = head.headers, .address = address};
      if (settings_.behind_proxy) request.address = forwarded_address(request, address);
      if (!settings_.behind_proxy)
        for (const char* header : {"x-forwarded-for", "x-forwarded-proto"})
          request.headers.erase(header);
      if (head.refused == 0) head.refused = read_body(client, head, received, request.body);
      if (head.refused == 0 && !requests_.allows(request.address)) head.refused = 429;
      if (head.refused != 0) {
        client.expires_after({});
        send_response(client, refusal_of(head.refused, head.lacks_host), false);
        drain_input(client);
        return;
      }
      const bool is_persistent =
          head.is_persistent && count < requests_a_connection && !is_stopping_;
      HttpResponse response = answer_to(head.target, request);
      if (is_persistent) response.headers["Keep-Alive"] = keep_alive_;
      client.expires_after(settings_.limits.answer);
      if (!send_response(client, response, is_persistent, request.method == "HEAD") ||
          !is_persistent)
        return;
    }
  }

  /// Whether a request begins in time.
  bool has_more(TimedStream& client, std::string& received) {
    TimedStream::ErrorCode error;
    client.expires_after(settings_.limits.idle);
    if (received.empty())
      net::read(client, net::dynamic_buffer(received, settings_.limits.head_bytes),
                net::transfer_at_least(1), error);
    return !error;
  }

  RequestHead read_head(TimedStream& client, std::string& received) {
    TimedStream::ErrorCode error;
    client.expires_after(settings_.limits.head);
    const std::size_t size = net::read_until(
        client, net::dynamic_buffer(received, settings_.limits.head_bytes), "\r\n\r\n", error);
    if (error) return {.refused = error == net::error::not_found ? 431 : 408};
    RequestHead head =
        parse_request_head(std::string_view(received).substr(0, size), settings_.limits);
    received.erase(0, size);
    return head;
  }

  /// Reads the body. Returns the status with which the request is refused, or 0.
  int read_body(TimedStream& client, const RequestHead& head, std::string& received,
                std::string& body) {
    TimedStream::ErrorCode error;
    client.expires_after(settings_.limits.body);
    if (received.size() < head.body_length) {
      constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
      if (head.expects_continue) net::write(client, net::buffer(go_on), error);
      net::read(client, net::dynamic_buffer(received),
                net::transfer_exactly(head.body_length - received.size()), error);
      if (error) return 408;
    }
    body = received.substr(0, head.body_length);
    received.erase(0, head.body_length);
    return 0;
  }

  HttpResponse answer_to(const std::string& target, HttpRequest& request) {
    std::optional<std::vector<std::string>> path = plain_path(target);
    if (!path) return http_refusal(404, "unknown", "page not found", "check the address");
    request.path = std::move(*path);
    try {
      return answer_(request);
    } catch (const std::exception& error) {
      if (failure_) failure_(error.what());
      return http_refusal(500, "failed", "internal server error", "please tell the experimenter");
    }
  }

  HttpSettings settings_;
  RateLimit requests_;
  HttpHandler answer_;
  HttpFailureHandler failure_;
  const std::string keep_alive_ =
      "timeout=" + std::to_string(settings_.limits.idle / std::chrono::seconds(1));
  std::atomic<bool> is_stopping_ = false;
  std::atomic<int> open_ = 0;
  net::io_context context_;
  tcp::acceptor acceptor_;
  net::thread_pool connections_;
  std::thread thread_;
};

HttpServer::HttpServer(const HttpSettings& settings, HttpHandler answer, HttpFailureHandler failure)
    : listener_(std::make_unique<Listener>(settings, std::move(answer), std::move(failure))) {}

HttpServer::~HttpServer() = default;

int HttpServer::port() const { return listener_->port(); }

}  // namespace mien::pipeline
