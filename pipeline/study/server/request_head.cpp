#include "pipeline/study/server/request_head.h"

#include <algorithm>
#include <iterator>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>

namespace mien::pipeline {

namespace {

namespace http = boost::beast::http;

using HeadParser = http::request_parser<http::empty_body>;

/// Beast reports the same error for a number that is too large as for text that is not a number.
bool is_huge_length(std::string_view text) {
  constexpr std::string_view name = "\r\ncontent-length:";
  const std::string lower = boost::algorithm::to_lower_copy(std::string(text));
  const std::size_t at = lower.find_first_not_of(" \t", lower.find(name) + name.size());
  const std::size_t end = lower.find_first_not_of("0123456789", at);
  return end >= at + 20 && lower[end] == '\r';
}

bool is_visible(char character) { return character > 0x20 && character < 0x7f; }

bool is_digit(char character) { return character >= '0' && character <= '9'; }

/// The HTTP status for what the parser refuses, or for what it accepts and this server does not:
/// folded lines, repeated lengths, requests to a proxy. 0: accepted.
int refused_lines(std::string_view text, const RequestLimits& limits, HeadParser& parser) {
  boost::beast::error_code error;
  parser.header_limit(static_cast<std::uint32_t>(limits.head_bytes));
  parser.body_limit(limits.body_bytes);
  parser.put(boost::asio::buffer(text), error);
  const auto& head = parser.get();
  if (error == http::error::body_limit) return 413;
  if (error == http::error::bad_content_length && is_huge_length(text)) return 413;
  if (error == http::error::bad_transfer_encoding || head.count(http::field::transfer_encoding) > 0)
    return 411;
  if (std::distance(head.begin(), head.end()) > static_cast<std::ptrdiff_t>(limits.header_lines))
    return 431;
  const bool goes_on = text.find("\r\n ") != text.npos || text.find("\r\n\t") != text.npos;
  if (error || goes_on || head.method() == http::verb::unknown || head.target().front() != '/' ||
      !std::ranges::all_of(head.target(), is_visible) ||
      head.count(http::field::content_length) > 1 ||
      !std::ranges::all_of(head[http::field::content_length], is_digit))
    return 400;
  const auto encoding = head[http::field::content_encoding];
  if (!encoding.empty() && !boost::beast::iequals(encoding, "identity")) return 415;
  return head.method() == http::verb::post && !parser.content_length() ? 411 : 0;
}

}  // namespace

RequestHead parse_request_head(std::string_view text, const RequestLimits& limits) {
  HeadParser parser;
  RequestHead head{.refused = refused_lines(text, limits, parser)};
  if (head.refused != 0) return head;
  const auto& lines = parser.get();
  // RFC 9112 §3.2. Without it the host name that the client used is unknown.
  head.lacks_host = lines.count(http::field::host) != 1 || lines[http::field::host].empty();
  if (head.lacks_host) head.refused = 400;
  head.method = std::string(lines.method_string());
  head.target = std::string(lines.target());
  head.is_persistent = lines.version() == 11 && lines.keep_alive();
  head.expects_continue = boost::beast::iequals(lines[http::field::expect], "100-continue");
  head.body_length = parser.content_length().value_or(0);
  for (const auto& line : lines)
    head.headers.emplace(boost::algorithm::to_lower_copy(std::string(line.name_string())),
                         line.value());
  return head;
}

}  // namespace mien::pipeline
