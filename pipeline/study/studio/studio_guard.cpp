#include "pipeline/study/studio/studio_guard.h"

#include <algorithm>
#include <array>

namespace mien::pipeline {

namespace {

bool is_this_machine(const std::string& host, int port) {
  const std::array<std::string, 3> names = {"127.0.0.1", "localhost", "[::1]"};
  return std::ranges::any_of(
      names, [&](const std::string& name) { return host == name + ":" + std::to_string(port); });
}

/// Whether a request is a navigation by a link.
bool is_followed_link(const HttpRequest& request) {
  return request.method == "GET" && header_of(request, "sec-fetch-mode") == "navigate" &&
         header_of(request, "sec-fetch-dest") == "document";
}

}  // namespace

std::optional<HttpResponse> cross_site_refusal(const HttpRequest& request, int port) {
  const std::string host = header_of(request, "host"), origin = header_of(request, "origin"),
                    site = header_of(request, "sec-fetch-site");
  if (!is_this_machine(host, port))
    return http_refusal(421, "host", "this is not the name of this server",
                        "use the link as printed");
  if (!origin.empty() && origin != "http://" + host)
    return http_refusal(403, "origin", "this comes from another site", "use the studio's own page");
  if (!site.empty() && site != "same-origin" && site != "none" && !is_followed_link(request))
    return http_refusal(403, "origin", "this comes from another site", "use the studio's own page");
  return std::nullopt;
}

bool same_secret(const std::string& given, const std::string& secret) {
  unsigned char different = given.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < secret.size(); ++i) {
    const char letter = i < given.size() ? given[i] : '\0';
    different |= static_cast<unsigned char>(letter ^ secret[i]);
  }
  return different == 0;
}

}  // namespace mien::pipeline
