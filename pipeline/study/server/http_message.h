#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mien::pipeline {

/// A complete request.
struct HttpRequest {
  std::string method;             ///< "GET", "HEAD", "POST", …
  std::vector<std::string> path;  ///< segments: {"s", "a1", ""} for "/s/a1/" (plain_path)
  std::map<std::string, std::string> headers;  ///< by lower-case name; the first of repeated ones
  std::string body;
  std::string address;  ///< IP address of the client: "127.0.0.1"
};

/// A byte range of a file.
struct FilePart {
  std::filesystem::path file;
  std::uint64_t offset = 0;  ///< bytes
  std::uint64_t length = 0;  ///< bytes
};

/// A response. The server adds security headers.
struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  std::optional<FilePart> part;  ///< sent instead of `body`
  std::map<std::string, std::string> headers;

  /// Whether the content security policy allows the page to compile WebAssembly
  /// ('wasm-unsafe-eval').
  bool webassembly = false;
};

/// Whether Content-Type is "application/json", with or without parameters.
bool is_json(const HttpRequest& request);

/// An error response with the body {"error": …, "wrong": …, "remedy": …}.
HttpResponse http_refusal(int status, const std::string& error, const std::string& wrong,
                          const std::string& remedy);

/// 429: the client has exceeded a rate limit.
HttpResponse http_too_many_requests();

/// 405: the method is not allowed. `allowed` lists the allowed methods: "GET, HEAD".
HttpResponse http_method_not_allowed(const std::string& allowed);

/// 200 with JSON text as the body.
HttpResponse http_json(const std::string& text);
/// The value as JSON with the given status.
HttpResponse http_value(const nlohmann::ordered_json& value, int status = 200);

/// The address of the client according to the web server in front of this one: the last in
/// X-Forwarded-For, which that server has added. `peer` if there is none or it is no IP address.
std::string forwarded_address(const HttpRequest& request, const std::string& peer);

/// The value of a header; empty if it is missing. `name` must be in lower case.
std::string header_of(const HttpRequest& request, const std::string& name);

/// A response with a file, or with the byte range that a "Range" header requests (RFC 9110 §14).
/// For several ranges or a malformed header, the whole file is sent. The status is 416 if no byte
/// of the file is in the range, and 404 for a missing file.
HttpResponse http_file(const HttpRequest& request, const std::filesystem::path& file,
                       const std::string& type);

/// The segments of a request path, without a query ("?…"). Nullopt if the path does not begin with
/// a slash, is longer than 512 characters, has characters other than slashes, letters, digits, '.',
/// '_' and '-', an empty segment before the last, or a segment that begins with a dot.
std::optional<std::vector<std::string>> plain_path(const std::string& target);

}  // namespace mien::pipeline
