#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace mien::motion {

/// Parses JSON from a file. NaN, which Python writes though JSON has no such value, is read as an
/// empty text. Throws mien::Error with line and column for a text that is not JSON ("this is not
/// the JSON of " and `what`), and for lists nested more than `max_json_depth` deep.
nlohmann::json parse_json_text(std::string_view text, const std::string& file,
                               const std::string& what);

}  // namespace mien::motion
