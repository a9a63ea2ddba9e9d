#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Parses the argument of --examples: "builtin:walks-10", a folder, or a pattern of files such as
/// "captures/*walk*.bvh". Throws Error for the built-in set that cannot be blended.
Examples parse_examples(const std::string& text);

/// The built-in set whose motions cannot be blended.
inline constexpr char unblendable_set[] = "actors";

/// Throws Error if the examples cannot be blended.
void refuse_unblendable(const Examples& examples);

/// Parses the argument of --weights: "normal=0.6,proud=0.4". Throws Error, also if all are 0.
NamedValues parse_weights(const std::string& text);

/// The syntax of parse_examples, for help texts.
inline constexpr char examples_help[] =
    "builtin:walks-10, a folder, or a quoted pattern such as 'captures/*walk*.bvh'";

}  // namespace mien::pipeline
