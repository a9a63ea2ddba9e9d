#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// Looks up an environment variable.
using Environment = std::function<std::optional<std::string>(const std::string&)>;

/// The environment of this process.
Environment process_environment();

/// A text with its variables replaced, or the reason why this failed.
struct Expansion {
  std::string text;
  bool expanded = false;  ///< whether the text contained variables
  std::string wrong;      ///< what is wrong; empty on success
  std::string remedy;
};

/// Replaces ${NAME} and ${NAME:-default}, where the default is used if NAME is unset or empty. It
/// fails if NAME is unset and no default is given, if the value is not UTF-8, or if the notation is
/// malformed. "$${" stands for "${".
Expansion expand(std::string_view text, const Environment& environment);

}  // namespace mien::pipeline
