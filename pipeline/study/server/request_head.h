#pragma once

#include <chrono>
#include <string_view>

#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// How much a client may send, and how long it may take. Times are of the whole, not of a piece: a
/// byte now and then holds nobody up.
struct RequestLimits {
  std::size_t head_bytes = 16 * 1024;  ///< request line and headers
  std::size_t header_lines = 100;
  std::size_t body_bytes = 64 * 1024;
  std::chrono::milliseconds idle{10'000};  ///< between requests
  std::chrono::milliseconds head{10'000};
  std::chrono::milliseconds body{20'000};
  std::chrono::milliseconds answer{300'000};
};

/// Request line and headers.
struct RequestHead {
  int refused = 0;  ///< HTTP status with which it is refused; 0: it is not
  std::string method;
  std::string target;        ///< visible ASCII, from '/'
  bool stays = true;         ///< the client may ask more over the same connection
  bool awaits_word = false;  ///< sends its body only when told to
  bool lacks_host = false;   ///< and is refused because of that
  std::size_t body_length = 0;
  std::map<std::string, std::string> headers;  ///< names in lower case; of twins, the first
};

/// Refuses malformed lines, a request that does not say whom it is for (Host), a body whose length
/// is not told plainly once, a compressed or too long one. `text` ends with the empty line.
RequestHead parse_request_head(std::string_view text, const RequestLimits& limits);

}  // namespace mien::pipeline
