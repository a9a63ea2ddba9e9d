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

/// A text with its variables replaced, or why it could not be.
struct Expansion {
  std::string text;
  bool expanded = false;  ///< there was something to replace
  std::string wrong;      ///< empty when all went well
  std::string remedy;
};

/// Replaces ${NAME} and ${NAME:-default} (used when NAME is unset or empty). "$${" stands for "${".
Expansion expand(std::string_view text, const Environment& environment);

}  // namespace mien::pipeline
