#pragma once

#include <functional>
#include <memory>
#include <string>

#include "pipeline/study/server/http_message.h"
#include "pipeline/study/server/rate_limit.h"
#include "pipeline/study/server/request_head.h"

namespace mien::pipeline {

/// Version of Boost (the server uses Asio and Beast): "1.74.0".
std::string http_library();

struct HttpSettings {
  std::string listen = "127.0.0.1";  ///< local address to bind to
  int port = 0;                      ///< 0: any free port
  int connections = 640;             ///< maximum number at once, each with a thread of its own;
                                     ///< further ones are refused with 503
  /// All requests come from a web server that states the client's address and protocol in the
  /// headers X-Forwarded-For and X-Forwarded-Proto. Otherwise these headers are ignored.
  bool behind_proxy = false;
  RequestLimits limits;
  /// Rate limit of each client address. All participants in a laboratory may share one address
  /// while loading videos.
  Rate requests{.burst = 4000, .per_second = 400};
};

/// Handles a request. Called from several threads at once.
using HttpHandler = std::function<HttpResponse(const HttpRequest&)>;

/// Receives the message of an exception thrown by a handler. The client gets status 500 without the
/// message.
using HttpFailureHandler = std::function<void(const std::string&)>;

/// A web server. Each request is read completely, within limits, before it is handled. Paths
/// rejected by plain_path are refused. Each response has headers by which browsers run no content
/// of other origins, do not show the page in a frame of another page, and store nothing in their
/// caches.
class HttpServer {
 public:
  /// Starts listening. Throws Error if the address cannot be bound.
  HttpServer(const HttpSettings& settings, HttpHandler answer, HttpFailureHandler failure = {});
  /// Stops listening, and finishes the responses in progress.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace mien::pipeline
