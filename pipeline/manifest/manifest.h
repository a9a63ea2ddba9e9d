#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/interpolation/blend.h"
#include "motion/interpolation/interpolation_options.h"
#include "motion/interpolation/time_warp.h"
#include "pipeline/documents/places.h"
#include "pipeline/look/look.h"
#include "pipeline/manifest/modification.h"
#include "pipeline/ratings/expectation.h"
#include "render/scene/camera.h"
#include "render/video/video_kind.h"
#include "scenes/stage/layout.h"

namespace mien::pipeline {

/// Numbers by name, in the order of the manifest.
using NamedValues = std::vector<std::pair<std::string, double>>;

/// The motions that are blended: a built-in set or the files of a folder.
struct Examples {
  /// Cut one gait cycle, or take the whole motion, with keytimes at its pauses or at its peak.
  enum class Cycle { automatic, whole, start_peak_end };
  enum class Labels { from_name, file_name };

  std::string builtin;           ///< "walks-10" of "builtin:walks-10"; empty for a folder
  std::filesystem::path folder;  ///< resolved
  std::string include = "*";     ///< glob on file names
  std::string exclude;           ///< glob on file names; empty excludes nothing
  Cycle cycle = Cycle::automatic;
  std::vector<std::pair<std::string, std::vector<double>>> keytimes;  ///< by hand, by file stem
  bool blendable = true;  ///< on one body with corresponding moments; else each for itself
  Labels labels = Labels::from_name;  ///< the part of the name that differs, or all of it
  std::vector<std::pair<std::string, std::string>> given_labels;  ///< file stem → label
};

/// What people thought of the examples.
struct Ratings {
  enum class Source { none, builtin, simulated, file };

  Source source = Source::none;
  std::filesystem::path file;              ///< CSV of answers or of means, resolved
  int raters = 14;                         ///< simulated only
  std::vector<Expectation> expected = {};  ///< which examples should lie above which
};

/// What the ratings are on: the built-in 41 adjective pairs, or a file.
struct ScalesSource {
  std::filesystem::path file;  ///< empty: built-in
};

/// What emotions are made of.
struct RecipesSource {
  std::string name = "builtin";  ///< or "fig29", or what was written
  std::filesystem::path file;    ///< resolved; empty for what comes with the program
};

enum class Quality { draft, standard, final };
enum class FrameFormat { none, png, png16, exr, layers };

/// What a video shows before and after the film, in this order: card, fixation cross, blank, film,
/// blank; each as many whole frames as come nearest to its seconds. Frame files are the film alone.
struct Presentation {
  std::string card;               ///< a text, lines parted by \n; empty for none
  double card_seconds = 2.0;      ///< when there is a text
  double fixation_seconds = 0.0;  ///< a cross in the middle
  int fixation_size = 32;         ///< pixels from end to end
  double blank_before = 0.0;      ///< seconds
  double blank_after = 0.0;       ///< seconds
  double fade_in = 0.0;           ///< seconds of the film that rise from the background
  double fade_out = 0.0;          ///< seconds of the film that sink into it
  double background = 0.5;        ///< grey, sRGB: 0 black … 1 white

  friend bool operator==(const Presentation&, const Presentation&) = default;
};

/// What is written for a stimulus, and how large.
struct Output {
  std::array<int, 2> size{960, 540};  ///< pixels of the picture that the camera frames
  double scale = 1.0;                 ///< all is drawn so many times as large, and shows the same
  std::optional<std::array<int, 4>> crop;  ///< the part that is kept, in pixels of `size`: from the
                                           ///< left, from the top, width, height
  double fps = 30.0;
  int cycles = 3;         ///< repetitions of a looping clip
  bool in_place = false;  ///< walk on the spot instead of travelling
  Quality quality = Quality::standard;
  FrameFormat frames = FrameFormat::png;
  double shutter = 0.0;  ///< degrees of 360 for which the shutter is open: motion blur
  std::vector<render::VideoKind> video{render::VideoKind::mp4};  ///< each once
  Presentation presentation;
  bool bvh = true;   ///< clips/<id>.bvh
  bool glb = false;  ///< clips/<id>.glb

  /// Pixels of the picture that the camera frames, drawn to scale.
  std::array<int, 2> whole_size() const;

  /// The part of it that is kept, if not all.
  std::optional<render::Window> window() const;

  /// Pixels of what is kept: of the frames and videos.
  std::array<int, 2> shown_size() const;

  friend bool operator==(const Output&, const Output&) = default;
};

/// How examples become a clip.
struct Interpolation {
  motion::InterpolationOptions weights;  ///< from adjectives to shares of the examples
  motion::RotationBlend rotations = motion::RotationBlend::karcher_mean;
  motion::WarpShape time_warp = motion::WarpShape::monotone;
  bool foot_lock = true;

  friend bool operator==(const Interpolation&, const Interpolation&) = default;
};

/// A motion file shown as it is.
struct ClipSource {
  std::filesystem::path file;                ///< resolved
  std::optional<std::array<int, 2>> frames;  ///< first and last, counted from 0; all when absent
};

enum class Role { target, created, reference };

/// One motion to make. Exactly one of adjectives, features, weights and clip is given.
struct Stimulus {
  std::string path;  ///< in the manifest: "stimuli[2]"
  std::string id;    ///< safe as a file name
  Role role = Role::created;
  NamedValues adjectives;  ///< parameter → 0…1
  NamedValues features;    ///< feature parameter → 0…1 (feature_parameters.h)
  NamedValues weights;     ///< example → share, ≥ 0, not all 0
  std::optional<ClipSource> clip;
  Look look;                             ///< the manifest's with this stimulus's own values over it
  Output output;                         ///< likewise
  Interpolation interpolation;           ///< likewise
  std::vector<ModificationStep> modify;  ///< done to what the above makes, in this order
  OnFault on_fault = OnFault::warn;      ///< the manifest's, or its own
};

/// A sheet about two motions, a gallery of several, or pictures of several stimuli.
struct Sheet {
  std::string path;       ///< in the manifest: "sheets[0]"
  std::string id;         ///< file name; "<target>_<created>", "gallery" or "stills" unless given
  std::string target;     ///< stimulus or example
  std::string created;    ///< stimulus or example
  std::string reference;  ///< stimulus or example; empty for none
  /// Stimuli or examples, one a row, the first being what the others are measured against; then
  /// there is no target. Empty for others.
  std::vector<std::string> gallery;
  std::vector<std::string> stills;  ///< stimuli, a picture each; empty for others
  int columns = 6;                  ///< of pictures
};

/// Motions together on one stage.
struct Overlay {
  /// What it is called and how it is filmed (path "overlays[0]"); it has no motion of its own.
  Stimulus film;
  std::string target;     ///< stimulus or example
  std::string created;    ///< stimulus or example
  std::string reference;  ///< stimulus or example; empty for none
  scenes::Layout layout = scenes::Layout::superimposed;
  double opacity = 0.75;  ///< of figures in the same place; those side by side are opaque
};

/// What each figure of an overlay stands for, and its motion.
std::vector<std::pair<Role, std::string>> motions_on(const Overlay& overlay);

/// All motions on a sheet.
std::vector<std::string> motions_on(const Sheet& sheet);

/// Two motions whose distance a sheet shows.
struct MotionPair {
  std::string target;
  std::string created;
};

/// A comparison's one; a gallery's first motion with each other; none of pictures.
std::vector<MotionPair> pairs_on(const Sheet& sheet);

/// What all stimuli of a study are made alike in.
struct Equalize {
  bool luminance = false;  ///< mean luminance of the films, by the exposure
  bool size = false;       ///< pixels that figures are tall, by the camera's distance
  bool duration = false;   ///< number of frames: that of the shortest

  friend bool operator==(const Equalize&, const Equalize&) = default;
};

/// A production as its author wrote it, defaults filled in and overrides merged.
struct Manifest {
  std::filesystem::path file;
  std::string study;
  std::uint64_t seed = 0;
  Examples examples;
  Ratings ratings;
  ScalesSource scales;
  Look look;
  Output output;
  Interpolation interpolation;
  RecipesSource recipes;
  OnFault on_fault = OnFault::warn;
  Equalize equalize;
  std::vector<Stimulus> stimuli;
  std::vector<Overlay> overlays;
  std::vector<Sheet> sheets;
  Places places;
};

/// All that films are made of: the stimuli, then the overlays.
std::vector<const Stimulus*> films_of(const Manifest& manifest);

}  // namespace mien::pipeline
