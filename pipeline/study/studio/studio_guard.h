#pragma once

#include <optional>
#include <string>

#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// The refusal of a request from a page of another site; nullopt where the request is allowed.
/// Guards against DNS rebinding ("Host" must name the loopback and `port`) and against cross-site
/// forms and scripts ("Origin", "Sec-Fetch-Site"). Following a link from another site is allowed.
std::optional<HttpResponse> cross_site_refusal(const HttpRequest& request, int port);

/// Compares in constant time.
bool same_secret(const std::string& given, const std::string& secret);

}  // namespace mien::pipeline
