#pragma once

#include <string>
#include <vector>

#include "motion/formats/gltf/gltf_library.h"
#include "motion/formats/gltf/gltf_nodes.h"

namespace mien::motion {

/// An animation channel with its sampler: one component of one node's transform over time.
struct GltfTrack {
  enum class Part { translation, rotation, scale };
  enum class Interpolation { step, linear, cubic_spline };

  int node = 0;
  Part part = Part::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> times;  ///< seconds, increasing, at least one

  /// For each keyframe, 3 numbers, or 4 for a quaternion (x, y, z, w); for cubic splines three
  /// times as many: in-tangent, value, out-tangent.
  std::vector<double> numbers;
};

/// Key in the `extras` of an animation in which the GLB writer states a frame rate below 10 frames
/// per second, because the keyframe times alone do not determine it.
inline constexpr const char* gltf_rate_key = "framesPerSecond";

/// An animation of a file that moves any node.
struct GltfTake {
  int animation = 0;
  std::string name;  ///< as in the file; "take 3" for the third animation of the file if it has no
                     ///< name; "Walk 2" for the second one named "Walk"
};

std::vector<GltfTake> gltf_takes(const GltfFile& file);

/// The tracks of an animation of the file. Throws mien::Error for keyframe times that are negative
/// or do not increase, more or fewer values than keys, two tracks for the same component of a node,
/// rotations of length zero, and for the reasons of `accessor_numbers`.
std::vector<GltfTrack> parse_tracks(const GltfFile& file, int animation);

/// The frame rate stated by the GLB writer for an animation; 0 if there is none.
double stated_frame_rate(const GltfFile& file, int animation);

/// Sets the component of the transform that the track animates to its value at `seconds`, clamped
/// to the first and last key (glTF 2.0 specification, appendix C).
void apply(const GltfTrack& track, double seconds, NodeTransform& transform);

/// The times at which tracks are sampled.
struct TrackTiming {
  double first = 0.0;  ///< seconds of the first key of all tracks
  double last = 0.0;   ///< seconds of the last key of all tracks
  double frames_per_second = 30.0;
  std::vector<double> keys;  ///< times of the frames, if they are evenly spaced keys that span all
                             ///< tracks; otherwise empty
};

/// The sampling times of tracks (at least one). The frame rate is that of the track with the most
/// keys if they are evenly spaced at 10 per second or more. A lower rate is accepted only if it
/// equals `stated`, or if all tracks have the same key times (at least eight) and none is a cubic
/// spline, which indicates a recording rather than sparse keyframes. Otherwise the rate is
/// `stated`, or 30 frames per second if `stated` is 0.
TrackTiming timing_of(const std::vector<GltfTrack>& tracks, double stated = 0.0);

/// Number of frames from the first key to the last, inclusive.
size_t frame_count(const TrackTiming& timing);

/// The time at which a frame is sampled, seconds. If frames coincide with keys, it is the time of
/// the key, which may be rounded, so that the frame equals the key.
double seconds_of_frame(const TrackTiming& timing, size_t frame);

}  // namespace mien::motion
