#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mien::pipeline {

/// A request, read whole.
struct HttpRequest {
  std::string method;             ///< "GET", "HEAD", "POST", …
  std::vector<std::string> path;  ///< "/s/a1/" is {"s", "a1", ""}; letters, digits, '.', '_', '-'
  std::map<std::string, std::string>
      headers;  ///< names in lower case; the first of repeated headers
  std::string body;
  std::string address;  ///< IP address of the client: "127.0.0.1"
};

/// A byte range of a file.
struct FilePart {
  std::filesystem::path file;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

/// A response. The server adds security headers to each.
struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  std::optional<FilePart> part;  ///< sent in place of `body`
  std::map<std::string, std::string> headers;

  /// Whether the content security policy lets the page compile WebAssembly ('wasm-unsafe-eval').
  bool webassembly = false;
};

/// Whether Content-Type is "application/json", with or without parameters.
bool is_json(const HttpRequest& request);

/// An error response with the body {"error": …, "wrong": …, "remedy": …}.
HttpResponse http_refusal(int status, const std::string& error, const std::string& wrong,
                          const std::string& remedy);

/// 429: a client that exceeds a rate limit.
HttpResponse http_too_many_requests();

/// 405: the method is not allowed. `allowed` lists those that are: "GET, HEAD".
HttpResponse http_method_not_allowed(const std::string& allowed);

/// 200 with JSON text as the body.
HttpResponse http_json(const std::string& text);
HttpResponse http_value(const nlohmann::ordered_json& value, int status = 200);

/// The value of a header; empty without it. `name` is in lower case.
std::string header_of(const HttpRequest& request, const std::string& name);

/// A file, or the range of it that a "Range" header requests (RFC 9110 §14). Several ranges at once
/// are answered with the whole file, a range beyond its end with 416, a missing file with 404.
HttpResponse http_file(const HttpRequest& request, const std::filesystem::path& file,
                       const std::string& type);

/// The segments of a path; nullopt for one with characters other than letters, digits, '.', '_' and
/// '-', with empty segments before the last, or with segments that begin with a dot.
std::optional<std::vector<std::string>> plain_path(const std::string& target);

}  // namespace mien::pipeline
