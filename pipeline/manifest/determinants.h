#pragma once

#include "pipeline/manifest/file_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

// What artifacts depend on, as parts of their keys.

/// What many tasks of a production share; found once, because files are read for it.
struct SharedDeterminants {
  Hash libraries;
  Hash repertoire;  ///< the examples, their ratings and scales
  FileKeys& files;
};

/// `files` outlives what is returned.
SharedDeterminants shared_determinants(const Manifest& manifest, FileKeys& files);

/// How a stimulus's motion is made, without the repertoire.
void add_motion(KeyBuilder& key, const Stimulus& stimulus, FileKeys& files);

/// How examples are blended.
void add_interpolation(KeyBuilder& key, const Interpolation& how);

/// How a shot is staged and drawn, without the motion.
void add_film(KeyBuilder& key, const Stimulus& stimulus, FileKeys& files);

/// What concerns tables and pages alone, as its values are: the text of the manifest may take them
/// from the environment.
void add_page(KeyBuilder& key, const Manifest& manifest);

/// What a video shows beside the film.
void add_presentation(KeyBuilder& key, const Presentation& presentation);

}  // namespace mien::pipeline
