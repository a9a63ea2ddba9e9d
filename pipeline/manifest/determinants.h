#pragma once

#include "pipeline/manifest/file_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

// Inputs on which artifacts depend, as parts of their keys.

/// The inputs shared by many tasks of a production; computed once, because files are read.
struct SharedDeterminants {
  Hash libraries;
  Hash repertoire;  ///< the examples, their ratings and scales
  FileKeys& files;
};

/// `files` must outlive the returned value.
SharedDeterminants shared_determinants(const Manifest& manifest, FileKeys& files);

/// Adds the settings and files that determine a stimulus's motion, except the repertoire.
void add_motion(KeyBuilder& key, const Stimulus& stimulus, FileKeys& files);

/// Adds the interpolation settings.
void add_interpolation(KeyBuilder& key, const Interpolation& how);

/// Adds the settings by which a shot is staged and rendered, without the motion. The role is one of
/// them where its colour shows.
void add_film(KeyBuilder& key, const Stimulus& stimulus, FileKeys& files);

/// Adds the values of all settings, with what is stated about recordings, for tables and pages.
/// (The text of the manifest is not enough, since it may take values from environment variables.)
void add_page(KeyBuilder& key, const Manifest& manifest);

/// Adds what is heard in a video, if it has a sound: the file's content, how it is placed, the
/// stimulus that states it, the target of equalized loudness, and the libraries that only sound
/// needs.
void add_sound(KeyBuilder& key, const Stimulus& stimulus, const Equalize& equalize,
               FileKeys& files);

/// Adds what a video shows before and after the film.
void add_presentation(KeyBuilder& key, const Presentation& presentation);

}  // namespace mien::pipeline
