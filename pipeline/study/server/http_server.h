#pragma once

#include <functional>
#include <memory>
#include <string>

#include "pipeline/study/server/http_message.h"
#include "pipeline/study/server/rate_limit.h"
#include "pipeline/study/server/request_head.h"

namespace mien::pipeline {

/// Version of the library (Boost) that listens: "1.74.0".
std::string http_library();

struct HttpSettings {
  std::string listen = "127.0.0.1";  ///< address of this machine
  int port = 0;                      ///< 0: any that is free
  int connections = 192;             ///< at once; more are refused with 503
  RequestLimits limits;
  /// Of one address: all of a laboratory's participants may share one, and load their videos.
  Rate requests{.burst = 4000, .per_second = 400};
};

/// Called from several threads at once.
using HttpAnswer = std::function<HttpResponse(const HttpRequest&)>;

/// Told what an answer failed with; the client is told only that it did.
using HttpFailure = std::function<void(const std::string&)>;

/// A web server. Every request is read whole, within limits, before anything of it is answered;
/// only plain paths come through. Every answer carries headers that keep browsers from running or
/// framing anything that is not from here, and from keeping copies.
class HttpServer {
 public:
  /// Answers from now on. Throws Error when the address cannot be listened at.
  HttpServer(const HttpSettings& settings, HttpAnswer answer, HttpFailure failure = {});
  /// Ends the answers that are under way first.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace mien::pipeline
