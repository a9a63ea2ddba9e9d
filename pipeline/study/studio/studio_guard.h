#pragma once

#include <optional>
#include <string>

#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// Why a request is not answered, whatever it asks for; nothing where it may be. A page of another
/// site must not come to this server through a browser: neither by a name that was made to point to
/// this machine (DNS rebinding: "Host" must name the loopback and `port`), nor by a form or a
/// script of its own ("Origin", "Sec-Fetch-Site"). Only a link may be followed from elsewhere.
std::optional<HttpResponse> unwelcome(const HttpRequest& request, int port);

/// Compares without telling by its duration where they differ.
bool same_secret(const std::string& given, const std::string& secret);

}  // namespace mien::pipeline
