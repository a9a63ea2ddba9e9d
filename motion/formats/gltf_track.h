#pragma once

#include <string>
#include <vector>

#include "motion/formats/gltf_library.h"
#include "motion/formats/gltf_nodes.h"

namespace mien::motion {

/// How one part of one node's transform changes over time.
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

/// Where the writer of GLB states, in the `extras` of an animation, a rate that its keys do not
/// tell: below 10 frames a second.
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
std::vector<GltfTrack> take_tracks(const GltfFile& file, int animation);

/// The rate that a file written by mien says for the animation; 0 when none.
double stated_frame_rate(const GltfFile& file, int animation);

/// Puts the track's value at a time into the transform; before the first key and after the last one
/// it is theirs. Appendix C of the glTF 2.0 specification.
void apply(const GltfTrack& track, double seconds, NodeTransform& transform);

/// When to sample tracks.
struct TrackTiming {
  double first = 0.0;  ///< seconds of the first key of all tracks
  double last = 0.0;   ///< and of the last one
  double frames_per_second = 30.0;
  std::vector<double> keys;  ///< of evenly spaced keys that span all tracks, their own times
};

/// At least one track. The rate is that of the track with most keys when they are evenly spaced at
/// 10 a second or more; slower ones too, when all tracks have the same eight keys or more, none of
/// them a spline, as recordings do: poses that somebody set by hand lie far apart as well, and what
/// lies between them is theirs. Else it is `stated`, or 30.
TrackTiming timing_of(const std::vector<GltfTrack>& tracks, double stated = 0.0);

/// Number of frames from the first key to the last.
size_t frame_count(const TrackTiming& timing);

/// Seconds at which a frame is sampled. Key times are rounded: where frames are keys, it is the
/// key's time, so that the frame is that key.
double seconds_of_frame(const TrackTiming& timing, size_t frame);

}  // namespace mien::motion
