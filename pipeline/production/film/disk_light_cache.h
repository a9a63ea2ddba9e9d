#pragma once

#include <cstdint>
#include <stop_token>

#include "pipeline/tasks/store.h"
#include "render/tracer/static_background_cache.h"

namespace mien::pipeline {

/// Maximum size in bytes of the light cache in a study's folder; the least recently used files are
/// removed first. (A set at 1920 x 1080 takes 25 MB.)
constexpr std::uintmax_t most_cached_light = 512'000'000;

/// Caches the light of static backgrounds in the study's folder, .mien/light/<name>, for later
/// runs, parts of films and other processes; a damaged file is replaced. While another process
/// renders the same set, this process waits for it. The returned cache must not outlive the store.
/// Calling it throws Interrupted after a stop request while it waits, and WriteFailure if a file
/// cannot be written.
render::LightCache disk_light_cache(Store& store, const std::stop_token& stop,
                                    std::uintmax_t most_bytes = most_cached_light);

}  // namespace mien::pipeline
