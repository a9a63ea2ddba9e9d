#include "pipeline/study/server/http_server.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>

#include "motion/error.h"
#include "pipeline/study/server/http_connection.h"

namespace mien::pipeline {

namespace {

constexpr int requests_a_connection = 1000;

constexpr char policy_header[] = "Content-Security-Policy";

/// What a page may load and run.
std::string content_policy(bool webassembly) {
  return std::string("default-src 'none'; script-src 'self'") +
         (webassembly ? " 'wasm-unsafe-eval'" : "") +
         "; style-src 'self'; img-src 'self' data: blob:; media-src 'self' blob:; connect-src "
         "'self' blob:; font-src 'self'; worker-src 'self' blob:; base-uri 'none'; "
         "form-action 'none'; frame-ancestors 'none'";
}

/// What every answer says to the browser beside its policy.
constexpr std::array<std::pair<const char*, const char*>, 7> guarding_headers = {{
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
    return http_refusal(status, "host", "the request does not say whom it is for", "send Host");
  switch (status) {
    case 408:
      return http_refusal(status, "slow", "the request took too long", "send it again");
    case 411:
      return http_refusal(status, "length", "the length is not told", "send Content-Length");
    case 413:
      return http_refusal(status, "long", "the request is too long", "send less");
    case 415:
      return http_refusal(status, "type", "the request is compressed", "send it plain");
    case 429:
      return http_refusal(status, "often", "too many requests", "wait a little");
    case 431:
      return http_refusal(status, "long", "the headers are too long", "send less");
    case 503:
      return http_refusal(status, "busy", "too many connections", "wait a little");
    default:
      return http_refusal(status, "malformed", "this is no request", "send it as HTTP/1.1");
  }
}

/// As the library would write it, of what it is not to see.
std::string farewell_text(int status, bool lacks_host = false) {
  HttpResponse response = refusal_of(status, lacks_host);
  std::string text = "HTTP/1.1 " + std::to_string(status) + " Refused\r\nConnection: close\r\n";
  if (status == 503) text += "Retry-After: 2\r\n";
  text += std::string(policy_header) + ": " + content_policy(false) + "\r\n";
  for (const auto& [name, value] : guarding_headers)
    text += std::string(name) + ": " + value + "\r\n";
  return text + "Content-Type: " + response.type +
         "\r\nContent-Length: " + std::to_string(response.body.size()) + "\r\n\r\n" + response.body;
}

/// Sends a part of a file, piece by piece.
httplib::ContentProvider provider_of(const FilePart& part) {
  auto file = std::make_shared<std::ifstream>(part.file, std::ios::binary);
  return [file, part](size_t offset, size_t length, httplib::DataSink& sink) {
    std::array<char, 65536> piece;
    const std::size_t wanted = std::min(length, piece.size());
    file->seekg(static_cast<std::streamoff>(part.offset + offset));
    file->read(piece.data(), static_cast<std::streamsize>(wanted));
    return file->gcount() == static_cast<std::streamsize>(wanted) &&
           sink.write(piece.data(), wanted);
  };
}

void send_response(const HttpResponse& response, httplib::Response& sent) {
  sent.status = response.status;
  sent.set_header(policy_header, content_policy(response.webassembly));
  for (const auto& [name, value] : guarding_headers) sent.set_header(name, value);
  for (const auto& [name, value] : response.headers) sent.set_header(name, value);
  if (!response.part) {
    sent.set_content(response.body, response.type);
  } else if (response.part->length == 0) {
    sent.set_content("", response.type);
  } else {
    sent.set_content_provider(response.part->length, response.type, provider_of(*response.part));
  }
}

/// The request line and nothing else: what else the head says has been read.
std::string bare_head(const RequestHead& head, bool stays) {
  return head.method + " " + head.target + " HTTP/1.1\r\n" +
         (stays ? "\r\n" : "Connection: close\r\n\r\n");
}

/// A thread a connection, as many as there may be. Those that are too many are served, and thereby
/// refused, by the thread that accepts connections.
class ConnectionThreads : public httplib::TaskQueue {
 public:
  /// Nothing or a bool, as the version of the library has it.
  using Enqueued = decltype(std::declval<httplib::TaskQueue>().enqueue({}));

  explicit ConnectionThreads(int most) : pool_(static_cast<std::size_t>(most)), most_(most) {}

  Enqueued enqueue(std::function<void()> connection) override {
    if (open_ >= most_) {
      connection();
      return Enqueued(true);
    }
    ++open_;
    return Enqueued(pool_.enqueue([this, connection = std::move(connection)] {
      connection();
      --open_;
    }));
  }

  void shutdown() override { pool_.shutdown(); }

 private:
  httplib::ThreadPool pool_;
  int most_;
  std::atomic<int> open_ = 0;
};

void reuse_port_of_the_dead(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

std::string http_library() { return CPPHTTPLIB_VERSION; }

class HttpServer::Listener : private httplib::Server {
 public:
  Listener(const HttpSettings& settings, HttpAnswer answer, HttpFailure failure)
      : settings_(settings),
        requests_(settings.requests),
        answer_(std::move(answer)),
        failure_(std::move(failure)) {
    new_task_queue = [this] { return new ConnectionThreads(settings_.connections); };
    set_socket_options(reuse_port_of_the_dead);
    set_tcp_nodelay(true);
    set_keep_alive_timeout(settings_.limits.idle.count() / 1000);  // told to clients
    set_keep_alive_max_count(requests_a_connection);
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      respond(request, response);
      return HandlerResponse::Handled;
    });
    bind();
    thread_ = std::thread([this] {
      accepting_ = std::this_thread::get_id();
      listen_after_bind();
    });
    while (!is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  ~Listener() override {
    is_stopping_ = true;
    stop();
    thread_.join();
  }

  int port() const { return port_; }

 private:
  void bind() {
    errno = 0;
    port_ = settings_.port;
    const bool is_bound = settings_.port == 0 ? (port_ = bind_to_any_port(settings_.listen)) > 0
                                              : bind_to_port(settings_.listen, settings_.port);
    if (is_bound) return;
    const std::string reason = errno != 0 ? std::strerror(errno) : "no such address here";
    throw Error({settings_.listen + ":" + std::to_string(settings_.port)},
                "cannot be listened at: " + reason,
                "choose another port with --port (0: any that is free) or address with --listen");
  }

  HttpResponse answer_to(const HttpRequest& request) {
    try {
      return answer_(request);
    } catch (const std::exception& error) {
      if (failure_) failure_(error.what());
      return http_refusal(500, "failed", "the server failed at this", "tell the experimenter");
    }
  }

  void respond(const httplib::Request& request, httplib::Response& sent) {
    const std::optional<std::vector<std::string>> path = plain_path(request.target);
    if (!path) {
      send_response(http_refusal(404, "unknown", "there is nothing here", "check the address"),
                    sent);
      return;
    }
    HttpRequest asked{.method = request.method,
                      .path = *path,
                      .body = request.body,
                      .address = request.remote_addr};
    for (const auto& [name, value] : request.headers) asked.headers.emplace(name, value);
    send_response(answer_to(asked), sent);
  }

  bool process_and_close_socket(socket_t socket) override {
    if (std::this_thread::get_id() == accepting_) {
      send_now(socket, farewell_text(503));
    } else {
      answer_requests(socket);
    }
    shutdown(socket, SHUT_RDWR);
    close(socket);
    return true;
  }

  void answer_requests(socket_t socket) {
    const std::string address = client_address(socket);
    RequestReader reader(socket, settings_.limits, [this] { return is_stopping_.load(); });
    for (int count = 1; count <= requests_a_connection; ++count) {
      RawRequest request = reader.next();
      if (request.is_over) return;
      if (request.head.refused == 0 && !requests_.allows(address)) request.head.refused = 429;
      if (request.head.refused != 0) {
        send_now(socket, farewell_text(request.head.refused, request.head.lacks_host));
        take_the_rest(socket);
        return;
      }
      const bool stays = request.head.stays && count < requests_a_connection && !is_stopping_;
      if (!answer_one(socket, request, stays) || !stays) return;
    }
  }

  bool answer_one(socket_t socket, const RawRequest& request, bool stays) {
    HttpConnection connection(socket, bare_head(request.head, stays), settings_.limits.answer);
    const auto set_up = [&](httplib::Request& asked) {
      asked.body = request.body;
      asked.headers.clear();
      for (const auto& [name, value] : request.head.headers) asked.headers.emplace(name, value);
      asked.headers.erase("accept-encoding");  // videos do not shrink, and secrets are not packed
      asked.headers.erase("expect");
    };
    bool closes = !stays;
    return process(*this, connection, !stays, closes, set_up);
  }

  /// The library has had two forms of this.
  template <class Self>
  static bool process(Self& self, HttpConnection& connection, bool is_last, bool& closes,
                      const std::function<void(httplib::Request&)>& set_up) {
    std::string remote, local;
    int remote_port = 0, local_port = 0;
    connection.get_remote_ip_and_port(remote, remote_port);
    connection.get_local_ip_and_port(local, local_port);
    if constexpr (requires {
                    self.process_request(connection, remote, remote_port, local, local_port,
                                         is_last, closes, set_up);
                  }) {
      return self.process_request(connection, remote, remote_port, local, local_port, is_last,
                                  closes, set_up);
    } else {
      return self.process_request(connection, is_last, closes, set_up);
    }
  }

  HttpSettings settings_;
  RateLimit requests_;
  HttpAnswer answer_;
  HttpFailure failure_;
  int port_ = 0;
  std::atomic<bool> is_stopping_ = false;
  std::atomic<std::thread::id> accepting_;
  std::thread thread_;
};

HttpServer::HttpServer(const HttpSettings& settings, HttpAnswer answer, HttpFailure failure)
    : listener_(std::make_unique<Listener>(settings, std::move(answer), std::move(failure))) {}

HttpServer::~HttpServer() = default;

int HttpServer::port() const { return listener_->port(); }

}  // namespace mien::pipeline
