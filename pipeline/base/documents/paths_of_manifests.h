#pragma once

#include <string_view>

namespace mien::pipeline {

/// The end of a remedy about a file that does not exist; of options, whose paths are taken from the
/// current folder, it is omitted.
inline constexpr std::string_view from_the_manifest =
    "; paths are taken from the manifest's folder";

}  // namespace mien::pipeline
