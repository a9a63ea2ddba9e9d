#pragma once

#include <filesystem>
#include <string>

#include "motion/live/live_bundle.h"

namespace mien::pipeline {

/// Path of the live core (motion/live/live_core.h) as WebAssembly (compiled by
/// motion/live/browser/build_module.sh): ../share/mien/pages/live_core/live_core.wasm relative to
/// an installed program's folder, or pages/live_core/live_core.wasm in a build folder. Empty if
/// neither file exists.
std::filesystem::path live_module_beside(const std::filesystem::path& program);

/// Path of the live core for the running program. Throws Error, with build instructions, if the
/// file does not exist.
std::filesystem::path live_module();

/// A script that embeds the live core and bundle, for pages opened from disk, where browsers
/// block fetching files. It sets `globalThis.mien_live_files` to { module, bundle }, each in
/// base64, for openWasm of pipeline/study/page/src/live/wasm_core.ts.
std::string live_script(const std::filesystem::path& module, const motion::LiveBundle& bundle);

}  // namespace mien::pipeline
