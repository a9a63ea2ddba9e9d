#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <stop_token>
#include <string>
#include <vector>

#include "motion/formats/bvh_stream.h"
#include "motion/formats/bvh_text.h"
#include "motion/rig/live_mapping.h"
#include "motion/stream/look_ahead.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

/// Bytes of a file, a pipe or standard input ("-") as they come.
class MotionSource {
 public:
  /// Throws Error when there is no such file, or it is a folder.
  explicit MotionSource(const std::string& file);
  ~MotionSource();
  MotionSource(const MotionSource&) = delete;
  MotionSource& operator=(const MotionSource&) = delete;

  /// As error messages call it.
  const std::string& name() const { return name_; }

  /// Waits for the next bytes. None at the end, or once `stop` is asked for. Throws
  /// std::system_error when reading fails.
  std::optional<std::string> next(const std::stop_token& stop);

 private:
  std::string name_;
  int descriptor_ = -1;
};

/// Where a stream's frames go, each as soon as it is there.
class MotionSink {
 public:
  enum class Form {
    bvh,    ///< hierarchy and frames
    lines,  ///< the frames' lines alone
  };

  /// To `out`, or to a file unless its name is empty. The file is written beside its name and takes
  /// it at the end (`publish`); without that nothing of it stays.
  MotionSink(std::ostream& out, std::filesystem::path file, Form form);
  ~MotionSink() = default;
  MotionSink(const MotionSink&) = delete;
  MotionSink& operator=(const MotionSink&) = delete;

  /// `claimed_frames` is what `Frames:` says where it cannot be mended later. Throws WriteFailure
  /// when the file cannot be written.
  void begin(const motion::Skeleton& body, double frames_per_second, std::size_t claimed_frames);

  /// False when whoever reads has gone. Throws WriteFailure when the file cannot be written.
  bool put(const motion::Pose& pose);

  /// Of a file: its number of frames, and its name.
  void publish();

 private:
  bool has_file() const { return !file_.empty(); }
  bool flushed();

  std::ostream& out_;
  std::filesystem::path file_;
  std::optional<ResultFile> unfinished_;
  Form form_;
  std::ofstream in_file_;
  std::streamoff count_place_ = 0;
  std::size_t frames_ = 0;
  std::string line_;
  std::optional<motion::BvhText> text_;
};

/// What a stream is to do.
struct LiveOptions {
  std::string name;  ///< of the source
  motion::Modification modification;
  motion::PathScope scope = motion::PathScope::body;
  std::optional<double> delay_ms;                ///< the shortest that will do without it
  std::optional<motion::Recording> calibration;  ///< a recording of the stream's rig
  bool measure = false;  ///< keep everything, and hold it against the whole at the end
};

/// How far a stream came from what is made of the whole motion.
struct LiveMeasurement {
  motion::StreamError error;  ///< of the modification, against that of the whole
  /// The same of paths and posture alone, which look ahead. Left out are soft joint limits, which
  /// hold against how far the motion has gone until then, and acceleration, which is a stream's
  /// own.
  motion::StreamError of_paths_and_posture;
  motion::StreamError calibration;  ///< of the mapping, against one calibrated on the whole
  int plants = 0;
  double drift_m = 0.0;            ///< horizontal, largest over the plants of the motion that came
  double drift_of_source_m = 0.0;  ///< likewise, before it was modified
};

/// What was done.
struct LiveReport {
  std::size_t frames = 0;
  double frames_per_second = 0.0;
  motion::StreamDelay delay;
  double mean_computing_ms = 0.0;  ///< from a frame's text to its flushed answer
  double most_computing_ms = 0.0;
  double largest_lag = 0.0;  ///< frames that acceleration let a limb fall behind
  std::vector<std::string> warnings;
  std::optional<LiveMeasurement> measured;
};

/// A BVH text that is mapped, modified and written frame by frame.
class LiveStream {
 public:
  LiveStream(LiveOptions options, MotionSink& sink);

  /// Maps, modifies and writes what the first frame tells to begin with, then each. False when
  /// whoever reads has gone. Throws Error: a rig that cannot be mapped, a modification that cannot
  /// be streamed.
  bool take(const motion::BvhHead& head, const motion::Pose& pose);

  /// Whether a frame has come.
  bool has_begun() const { return stream_.has_value(); }

  /// Writes what the delay has kept back. Throws Error when no frame came.
  LiveReport finish();

 private:
  void begin(const motion::BvhHead& head, const motion::Pose& pose);
  bool put(const motion::Pose& pose);
  motion::Clip whole_modified(motion::Modification modification) const;
  LiveMeasurement measurement() const;

  LiveOptions options_;
  MotionSink& sink_;
  LiveReport report_;
  std::optional<motion::LiveMapping> mapping_;
  std::optional<motion::StreamedModification> stream_;
  motion::Recording source_;  ///< all of what came, when it is measured
  motion::Clip mapped_;       ///< likewise, on the body
  motion::Clip given_;        ///< likewise, modified
};

}  // namespace mien::pipeline
