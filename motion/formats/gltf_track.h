#pragma once

#include <string>
#include <vector>

#include "motion/formats/gltf_library.h"
#include "motion/formats/gltf_nodes.h"

namespace mien::motion {

/// An animation channel with its sampler: one component of one node's transform over time.
struct GltfTrack {
  enum class Part { translation, rotation, scale };
  enum class Interpolation { step, linear, cubic_spline };

  int node = 0;
  Part part = Part::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> times;  ///< seconds, increasing, at least one

  /// For each time 3 numbers or the 4 of a quaternion (x, y, z, w); for cubic splines three times
  /// as many: in-tangent, value, out-tangent.
  std::vector<double> numbers;
};

/// Key in the `extras` of an animation under which our GLB writer states a frame rate below 10
/// frames a second, which the key times do not determine.
inline constexpr const char* gltf_rate_key = "framesPerSecond";

/// An animation of a file that moves any node.
struct GltfTake {
  int animation = 0;
  std::string name;  ///< as the file says; "take 3" for the third animation without a name; the
                     ///< second of one name is called "Walk 2"
};

std::vector<GltfTake> gltf_takes(const GltfFile& file);

/// The tracks of an animation of the file.
/// Throws mien::Error: key times that do not increase or are negative, more or fewer values than
/// keys, two tracks for one part, rotations of length zero, and whatever `accessor_numbers`
/// refuses.
std::vector<GltfTrack> parse_tracks(const GltfFile& file, int animation);

/// The frame rate stated by our GLB writer for an animation; 0 when none.
double stated_frame_rate(const GltfFile& file, int animation);

/// Sets the track's value at a time in the transform, clamped to the first and last key (glTF 2.0
/// specification, appendix C).
void apply(const GltfTrack& track, double seconds, NodeTransform& transform);

/// When to sample tracks.
struct TrackTiming {
  double first = 0.0;  ///< seconds of the first key of all tracks
  double last = 0.0;   ///< and of the last one
  double frames_per_second = 30.0;
  std::vector<double> keys;  ///< of evenly spaced keys that span all tracks, their own times
};

/// When to sample tracks (at least one). The rate is that of the track with the most keys if they
/// are evenly spaced at 10 a second or more; also slower if all tracks have the same eight keys or
/// more and none is a spline, which indicates a recording rather than sparse keyframes. Else it is
/// `stated`, or 30.
TrackTiming timing_of(const std::vector<GltfTrack>& tracks, double stated = 0.0);

/// Number of frames from the first key to the last.
size_t frame_count(const TrackTiming& timing);

/// Seconds at which a frame is sampled. Key times are rounded: where frames are keys, it is the
/// key's time, so that the frame is that key.
double seconds_of_frame(const TrackTiming& timing, size_t frame);

}  // namespace mien::motion
