#pragma once

#include <cstdint>
#include <stop_token>

#include "pipeline/tasks/store.h"
#include "render/tracer/static_background_cache.h"

namespace mien::pipeline {

/// At most so many bytes of light are kept in a study's folder; what was used longest ago goes
/// first. (A set at 1920 x 1080 has 25 MB.)
constexpr std::uintmax_t most_cached_light = 512'000'000;

/// Caches the light of static backgrounds in the study's folder, .mien/light/<name>, where later
/// runs, parts of films and other processes find it; a file that is not as it was written is made
/// again. While another process draws a set, this one waits for it. What is returned must not
/// outlive the store; it throws Interrupted soon after a stop request, and WriteFailure.
render::LightCache disk_light_cache(Store& store, const std::stop_token& stop,
                                    std::uintmax_t most_bytes = most_cached_light);

}  // namespace mien::pipeline
