#pragma once

#include <chrono>
#include <string_view>

#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// Limits of the size and duration of requests. Each duration limits a whole part of the exchange,
/// so that a client sending occasional single bytes cannot keep a connection open.
struct RequestLimits {
  std::size_t head_bytes = 16 * 1024;  ///< request line and headers
  std::size_t header_lines = 100;
  std::size_t body_bytes = 64 * 1024;
  std::chrono::milliseconds idle{10'000};     ///< between requests
  std::chrono::milliseconds head{10'000};     ///< receiving the head
  std::chrono::milliseconds body{20'000};     ///< receiving the body
  std::chrono::milliseconds answer{300'000};  ///< sending the response
};

/// Request line and headers.
struct RequestHead {
  int refused = 0;  ///< HTTP status with which the request is refused; 0 if it is accepted
  std::string method;
  std::string target;         ///< visible ASCII characters, beginning with '/'
  bool is_persistent = true;  ///< persistent connection: further requests may follow
  bool expects_continue =
      false;  ///< "Expect: 100-continue": the body is sent only after an interim response
  /// The request is refused because its Host header is missing, empty or repeated.
  bool lacks_host = false;
  std::size_t body_length = 0;                 ///< bytes
  std::map<std::string, std::string> headers;  ///< by lower-case name; the first of repeated ones
};

/// Parses the head of a request. Refused are malformed or too many lines, unknown methods, a
/// missing, empty or repeated Host header, a target that is not a path, a body without exactly one
/// valid Content-Length, and a body that is compressed or too long. `text` must end with the empty
/// line.
RequestHead parse_request_head(std::string_view text, const RequestLimits& limits);

}  // namespace mien::pipeline
