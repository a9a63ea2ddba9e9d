#include "pipeline/study/server/request_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <string_view>

#include <poll.h>
#include <sys/socket.h>

namespace mien::pipeline {

namespace {

constexpr std::string_view line_end = "\r\n";
constexpr std::string_view head_end = "\r\n\r\n";
constexpr std::chrono::milliseconds glance_time{200};

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& character : result) {
    if (character >= 'A' && character <= 'Z') character = static_cast<char>(character - 'A' + 'a');
  }
  return result;
}

bool is_token(std::string_view text) {
  constexpr std::string_view marks = "!#$%&'*+-.^_`|~";
  return !text.empty() && std::ranges::all_of(text, [&](char character) {
    return (character >= '0' && character <= '9') || (character >= 'a' && character <= 'z') ||
           (character >= 'A' && character <= 'Z') || marks.find(character) != marks.npos;
  });
}

bool has_control_characters(std::string_view line) {
  return std::ranges::any_of(line, [](char character) {
    const auto code = static_cast<unsigned char>(character);
    return (code < 0x20 && character != '\t') || code == 0x7f;
  });
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// "GET /path HTTP/1.1"
bool read_request_line(std::string_view line, RequestHead& head) {
  const std::size_t first = line.find(' ');
  const std::size_t last = line.rfind(' ');
  if (first == line.npos || last < first + 2) return false;
  const std::string_view version = line.substr(last + 1);
  head.method = line.substr(0, first);
  head.target = line.substr(first + 1, last - first - 1);
  head.stays = version == "HTTP/1.1";
  return is_token(head.method) && head.target.front() == '/' &&
         std::ranges::all_of(head.target, [](char one) { return one > 0x20 && one < 0x7f; }) &&
         (version == "HTTP/1.1" || version == "HTTP/1.0");
}

bool read_header_line(std::string_view line, RequestHead& head) {
  const std::size_t colon = line.find(':');
  if (colon == line.npos || !is_token(line.substr(0, colon))) return false;
  const std::string name = lower_case(line.substr(0, colon));
  const bool is_first = head.headers.emplace(name, trimmed(line.substr(colon + 1))).second;
  return is_first || (name != "content-length" && name != "host");
}

/// Digits and nothing else; a longer number than any that is allowed counts as too long.
int read_length(std::string_view text, std::size_t most, std::size_t& length) {
  if (text.empty() || !std::ranges::all_of(text, [](char one) { return one >= '0' && one <= '9'; }))
    return 400;
  const auto error = std::from_chars(text.data(), text.data() + text.size(), length).ec;
  return error != std::errc{} || length > most ? 413 : 0;
}

int read_lines(std::string_view text, const RequestLimits& limits, RequestHead& head) {
  std::size_t lines = 0;
  for (std::size_t end = text.find(line_end); end != text.npos && end != 0;
       text.remove_prefix(end + line_end.size()), end = text.find(line_end)) {
    const std::string_view line = text.substr(0, end);
    if (has_control_characters(line)) return 400;
    if (lines > limits.header_lines) return 431;
    if (lines == 0 ? !read_request_line(line, head) : !read_header_line(line, head)) return 400;
    ++lines;
  }
  return lines == 0 ? 400 : 0;
}

std::string header_of(const RequestHead& head, const std::string& name) {
  const auto found = head.headers.find(name);
  return found == head.headers.end() ? std::string() : lower_case(found->second);
}

int read_body_headers(const RequestLimits& limits, RequestHead& head) {
  if (head.headers.contains("transfer-encoding")) return 411;
  const std::string encoding = header_of(head, "content-encoding");
  if (!encoding.empty() && encoding != "identity") return 415;
  const auto length = head.headers.find("content-length");
  if (length == head.headers.end()) return head.method == "POST" ? 411 : 0;
  return read_length(length->second, limits.body_bytes, head.body_length);
}

}  // namespace

RequestHead parse_request_head(std::string_view text, const RequestLimits& limits) {
  RequestHead head;
  head.refused = read_lines(text, limits, head);
  if (head.refused == 0) head.refused = read_body_headers(limits, head);
  // RFC 9112 §3.2; without it nobody knows by which name this server was called.
  if (head.refused == 0 && header_of(head, "host").empty()) {
    head.refused = 400;
    head.lacks_host = true;
  }
  if (header_of(head, "connection") == "close") head.stays = false;
  head.awaits_word = header_of(head, "expect") == "100-continue";
  return head;
}

RequestReader::Reading RequestReader::read_more(Clock::time_point deadline) {
  std::array<char, 8192> piece;
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return Reading::late;
    if (is_stopping_()) return Reading::ended;
    pollfd watched{socket_, POLLIN, 0};
    const int ready = poll(&watched, 1, static_cast<int>(std::min(left, glance_time).count()));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    if (ready < 0) return Reading::ended;
    const ssize_t count = recv(socket_, piece.data(), piece.size(), MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (count <= 0) return Reading::ended;
    buffer_.append(piece.data(), static_cast<std::size_t>(count));
    return Reading::some;
  }
}

bool RequestReader::wait_for_first_byte() {
  return !buffer_.empty() || read_more(Clock::now() + limits_.idle) == Reading::some;
}

RequestHead RequestReader::read_head() {
  const Clock::time_point deadline = Clock::now() + limits_.head;
  while (true) {
    const std::size_t end = buffer_.find(head_end);
    const std::size_t size = end == buffer_.npos ? buffer_.size() : end + head_end.size();
    if (size > limits_.head_bytes) return {.refused = 431};
    if (end != buffer_.npos) {
      RequestHead head = parse_request_head(std::string_view(buffer_).substr(0, size), limits_);
      buffer_.erase(0, size);
      return head;
    }
    if (read_more(deadline) != Reading::some) return {.refused = 408};
  }
}

int RequestReader::read_body(std::size_t length, std::string& body) {
  const Clock::time_point deadline = Clock::now() + limits_.body;
  while (buffer_.size() < length) {
    if (read_more(deadline) != Reading::some) return 408;
  }
  body = buffer_.substr(0, length);
  buffer_.erase(0, length);
  return 0;
}

RawRequest RequestReader::next() {
  RawRequest request;
  request.is_over = !wait_for_first_byte();
  if (request.is_over) return request;
  request.head = read_head();
  RequestHead& head = request.head;
  if (head.refused != 0) return request;
  if (head.awaits_word && buffer_.size() < head.body_length) {
    constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
    send(socket_, go_on.data(), go_on.size(), MSG_NOSIGNAL);
  }
  head.refused = read_body(head.body_length, request.body);
  return request;
}

}  // namespace mien::pipeline
