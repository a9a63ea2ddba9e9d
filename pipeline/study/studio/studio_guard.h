#pragma once

#include <optional>
#include <string>

#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// The response that refuses a request from a page of another site; nullopt if the request is
/// allowed. Guards against DNS rebinding ("Host" must be a loopback name with `port`) and against
/// cross-site forms and scripts ("Origin", "Sec-Fetch-Site"). Following a link from another site is
/// allowed.
std::optional<HttpResponse> cross_site_refusal(const HttpRequest& request, int port);

/// Compares in constant time, so that timing does not reveal the secret.
bool same_secret(const std::string& given, const std::string& secret);

}  // namespace mien::pipeline
