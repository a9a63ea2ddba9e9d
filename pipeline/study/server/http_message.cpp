#include "pipeline/study/server/http_message.h"

#include <algorithm>
#include <string_view>

#include <boost/asio/ip/address.hpp>
#include <nlohmann/json.hpp>

#include "motion/text/as_number.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t longest_path = 512;

bool is_plain(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         (character >= '0' && character <= '9') || character == '.' || character == '_' ||
         character == '-';
}

struct ByteRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;  ///< included
};

enum class RangeKind { whole, part, beyond };

/// A header that cannot be understood is passed over, as the standard has it.
RangeKind read_range(std::string_view header, std::uint64_t size, ByteRange& range) {
  constexpr std::string_view unit = "bytes=";
  if (!header.starts_with(unit)) return RangeKind::whole;
  header.remove_prefix(unit.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos || header.find(',') != std::string_view::npos)
    return RangeKind::whole;
  const std::string_view first_text = header.substr(0, dash);
  const std::string_view last_text = header.substr(dash + 1);
  const std::optional<std::uint64_t> first = motion::as_number<std::uint64_t>(first_text);
  const std::optional<std::uint64_t> last = motion::as_number<std::uint64_t>(last_text);
  if (first_text.empty()) {
    if (!last) return RangeKind::whole;
    if (*last == 0 || size == 0) return RangeKind::beyond;
    range = {size - std::min(*last, size), size - 1};
    return RangeKind::part;
  }
  if (!first || (!last_text.empty() && !last) || (last && *last < *first)) return RangeKind::whole;
  if (*first >= size) return RangeKind::beyond;
  range = {*first, last ? std::min(*last, size - 1) : size - 1};
  return RangeKind::part;
}

}  // namespace

HttpResponse http_json(const std::string& text) {
  return {.type = "application/json; charset=utf-8", .body = text};
}

HttpResponse http_refusal(int status, const std::string& error, const std::string& wrong,
                          const std::string& remedy) {
  HttpResponse response =
      http_value({{"error", error}, {"wrong", wrong}, {"remedy", remedy}}, status);
  response.body += "\n";
  return response;
}

HttpResponse http_too_many_requests() {
  HttpResponse response =
      http_refusal(429, "often", "too many requests", "wait a few seconds and ask again");
  response.headers["Retry-After"] = "5";
  return response;
}

HttpResponse http_method_not_allowed(const std::string& allowed) {
  HttpResponse response = http_refusal(405, "method", "this method is not allowed", allowed);
  response.headers["Allow"] = allowed;
  return response;
}

HttpResponse http_value(const nlohmann::ordered_json& value, int status) {
  HttpResponse response =
      http_json(value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  response.status = status;
  return response;
}

std::string forwarded_address(const HttpRequest& request, const std::string& peer) {
  const std::string list = header_of(request, "x-forwarded-for");
  std::string last = list.substr(list.rfind(',') + 1);  // npos + 1 is 0
  std::erase(last, ' ');
  boost::system::error_code fault;
  const auto address = boost::asio::ip::make_address(last, fault);
  return fault ? peer : address.to_string();
}

std::string header_of(const HttpRequest& request, const std::string& name) {
  const auto found = request.headers.find(name);
  return found == request.headers.end() ? std::string() : found->second;
}

bool is_json(const HttpRequest& request) {
  std::string type = header_of(request, "content-type");
  type = type.substr(0, type.find(';'));
  return type.substr(0, type.find_last_not_of(' ') + 1) == "application/json";
}

HttpResponse http_file(const HttpRequest& request, const std::filesystem::path& file,
                       const std::string& type) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (error)
    return http_refusal(404, "unknown", "the file does not exist", "please tell the experimenter");
  HttpResponse response{.type = type, .part = FilePart{file, 0, size}};
  response.headers["Accept-Ranges"] = "bytes";
  ByteRange range;
  const RangeKind kind = read_range(header_of(request, "range"), size, range);
  if (kind == RangeKind::beyond) {
    HttpResponse refusal = http_refusal(
        416, "range", "the file has " + std::to_string(size) + " bytes", "ask for less");
    refusal.headers["Content-Range"] = "bytes */" + std::to_string(size);
    return refusal;
  }
  if (kind == RangeKind::whole) return response;
  response.status = 206;
  response.part = FilePart{file, range.first, range.last - range.first + 1};
  response.headers["Content-Range"] = "bytes " + std::to_string(range.first) + "-" +
                                      std::to_string(range.last) + "/" + std::to_string(size);
  return response;
}

std::optional<std::vector<std::string>> plain_path(const std::string& target) {
  const std::string path = target.substr(0, target.find('?'));
  if (path.empty() || path.front() != '/' || path.size() > longest_path) return std::nullopt;
  std::vector<std::string> parts(1);
  for (std::size_t at = 1; at < path.size(); ++at) {
    if (path[at] == '/') {
      if (parts.back().empty()) return std::nullopt;
      parts.emplace_back();
    } else if (is_plain(path[at]) && !(parts.back().empty() && path[at] == '.')) {
      parts.back() += path[at];
    } else {
      return std::nullopt;
    }
  }
  return parts;
}

}  // namespace mien::pipeline
