#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/hash.h"
#include "pipeline/manifest.h"

namespace mien::pipeline {

// What artifacts depend on, as parts of their keys. Files count by name and content, not by the
// folder that they lie in.

void add_file(KeyBuilder& key, const std::filesystem::path& file);
void add_libraries(KeyBuilder& key);

/// The examples, their ratings and scales.
void add_repertoire(KeyBuilder& key, const Manifest& manifest);

/// How a stimulus's motion is made, without the repertoire.
void add_motion(KeyBuilder& key, const Stimulus& stimulus);

/// How a shot is staged and drawn, without the motion.
void add_film(KeyBuilder& key, const Stimulus& stimulus);

}  // namespace mien::pipeline
