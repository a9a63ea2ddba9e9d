#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// Why a request is not answered, whatever it asks for; nothing where it may be. A page of another
/// site must not come to this server through a browser: neither by a name that was made to point to
/// this machine (DNS rebinding: "Host" must name the loopback and `port`), nor by a form or a
/// script of its own ("Origin", "Sec-Fetch-Site"). Only a link may be followed from elsewhere.
std::optional<HttpResponse> unwelcome(const HttpRequest& request, int port);

/// Whether a JSON text holds arrays and objects in each other deeper than that: whoever walks
/// through them would run out of stack.
bool is_nested_deeper(std::string_view json, int most);

/// Compares without telling by its duration where they differ.
bool same_secret(const std::string& given, const std::string& secret);

}  // namespace mien::pipeline
