#pragma once

#include <filesystem>
#include <string>

#include "motion/live/live_bundle.h"

namespace mien::pipeline {

/// The motion core as WebAssembly, as motion/live/browser/build_module.sh compiles it:
/// ../share/mien/pages/live_core/live_core.wasm beside an installed program, or
/// pages/live_core/live_core.wasm beside one that was built. Empty when there is neither.
std::filesystem::path live_module_beside(const std::filesystem::path& program);

/// That file for the program that is running. Throws Error, with how to build it, when it is not
/// there.
std::filesystem::path live_module();

/// A script for a page opened from disk, which a browser does not let fetch files: it sets
/// `globalThis.mien_live_files` to { module, bundle }, each in base64, for openWasm of
/// pipeline/study/page/src/live/core.ts.
std::string live_script(const std::filesystem::path& module, const motion::LiveBundle& bundle);

}  // namespace mien::pipeline
