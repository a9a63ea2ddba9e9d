#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mien::pipeline {

/// What a client asks for.
struct HttpRequest {
  std::string method;             ///< "GET", "HEAD", "POST", …
  std::vector<std::string> path;  ///< "/s/a1/" is {"s", "a1", ""}; letters, digits, '.', '_', '-'
  std::map<std::string, std::string> headers;  ///< names in lower case; of twins, the first
  std::string body;
  std::string address;  ///< of the client: "127.0.0.1"
};

/// A part of a file.
struct FilePart {
  std::filesystem::path file;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

/// What it is answered. Headers that guard the client are added to every answer by the server.
struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  std::optional<FilePart> part;  ///< sent in place of `body`
  std::map<std::string, std::string> headers;

  /// A page that may compile WebAssembly; browsers count that as unsafe, so that no other may.
  bool webassembly = false;
};

/// Whether the body is told to be "application/json", with or without parameters.
bool is_json(const HttpRequest& request);

/// {"error": …, "wrong": …, "remedy": …}
HttpResponse http_refusal(int status, const std::string& error, const std::string& wrong,
                          const std::string& remedy);

/// Of one who asks too often for what is not there, or for too much.
HttpResponse http_too_often();

/// Of a method that is not among those that are allowed: "GET, HEAD".
HttpResponse http_wrong_method(const std::string& allowed);

/// JSON as an answer.
HttpResponse http_json(const std::string& text);
HttpResponse http_value(const nlohmann::ordered_json& value, int status = 200);

/// What a header says; nothing without it. `name` is in lower case.
std::string header_of(const HttpRequest& request, const std::string& name);

/// A file, or of it the part that a "Range" header asks for (RFC 9110 §14). Several ranges at once
/// are answered with the whole file, and a range beyond its end with 416; 404 without the file.
HttpResponse http_file(const HttpRequest& request, const std::filesystem::path& file,
                       const std::string& type);

/// The parts of a path; nothing for one that has other than plain characters, empty parts before
/// the last, or parts that begin with a dot.
std::optional<std::vector<std::string>> plain_path(const std::string& target);

}  // namespace mien::pipeline
