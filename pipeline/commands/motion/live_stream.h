#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <stop_token>
#include <string>
#include <vector>

#include "motion/formats/bvh/bvh_stream.h"
#include "motion/formats/bvh/bvh_text.h"
#include "motion/rig/live_mapping.h"
#include "motion/stream/look_ahead.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

/// Reads a file, a pipe or standard input ("-") as bytes arrive.
class MotionSource {
 public:
  /// Throws Error if the file does not exist, cannot be read, is a folder, or has the extension of
  /// a motion format that cannot be streamed.
  explicit MotionSource(const std::string& file);
  ~MotionSource();
  MotionSource(const MotionSource&) = delete;
  MotionSource& operator=(const MotionSource&) = delete;

  /// Name of the source in error messages.
  const std::string& name() const { return name_; }

  /// Waits for the next bytes. Returns nullopt at the end or after a stop request. Throws
  /// std::system_error if reading fails.
  std::optional<std::string> next(const std::stop_token& stop);

 private:
  std::string name_;
  int descriptor_ = -1;
};

/// Writes a stream's frames, each as soon as it is available.
class MotionSink {
 public:
  enum class Form {
    bvh,    ///< hierarchy and frames
    lines,  ///< the frames' lines alone
  };

  /// Writes to `file`, or to `out` if `file` is empty. The file is written under a temporary name
  /// and renamed by `publish`; without a call of `publish`, it is removed.
  MotionSink(std::ostream& out, std::filesystem::path file, Form form);
  ~MotionSink() = default;
  MotionSink(const MotionSink&) = delete;
  MotionSink& operator=(const MotionSink&) = delete;

  /// Writes the header (none for Form::lines). `claimed_frames` is stated in it as the number of
  /// frames, unless this number can be corrected later. Throws WriteFailure if the file cannot be
  /// written.
  void begin(const motion::Skeleton& body, double frames_per_second, std::size_t claimed_frames);

  /// Writes a frame. Returns false if the reader has closed the pipe. Throws WriteFailure if the
  /// file cannot be written.
  bool put(const motion::Pose& pose);

  /// Completes a file: writes the number of frames and gives it its final name.
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

/// Options of a live stream.
struct LiveOptions {
  std::string name;  ///< name of the source in messages
  motion::Modification modification;
  motion::PathScope scope = motion::PathScope::body;
  std::optional<double> delay_ms;  ///< delay, ms; empty: the shortest possible
  /// A recording of the stream's rig, with which the retargeting is calibrated; empty: it is
  /// calibrated with the stream's first frame.
  std::optional<motion::Recording> calibration;
  bool measure = false;  ///< keep all frames and compare them with offline processing at the end
};

/// The deviation of a stream from offline processing of the whole motion.
struct LiveMeasurement {
  motion::StreamError error;  ///< error of the modification
  /// Error of the path and posture modifications alone, which equal offline processing if the
  /// look-ahead suffices. Soft joint limits, which depend on the range of the motion so far, and
  /// acceleration, for which streams use another method, are excluded.
  motion::StreamError of_paths_and_posture;
  motion::StreamError
      calibration;       ///< error of the retargeting, relative to calibration on the whole motion
  int plants = 0;        ///< number of foot plants of the input motion
  double drift_m = 0.0;  ///< largest horizontal foot drift during these plants, metres
  double drift_of_source_m = 0.0;  ///< largest drift before modification, metres
};

/// Summary of a finished stream.
struct LiveReport {
  std::size_t frames = 0;
  double frames_per_second = 0.0;
  motion::StreamDelay delay;
  double mean_computing_ms = 0.0;  ///< mean time for processing a frame and writing the one due, ms
  double most_computing_ms = 0.0;  ///< maximum of that time, ms
  double largest_lag = 0.0;        ///< maximum lag of a limb due to acceleration, frames
  std::vector<std::string> warnings;
  std::optional<LiveMeasurement> measured;
};

/// Retargets, modifies and writes a BVH stream frame by frame.
class LiveStream {
 public:
  /// Throws Error for a modification that cannot be streamed. `sink` must outlive the stream.
  LiveStream(LiveOptions options, MotionSink& sink);

  /// Processes a frame; the first one also sets up the retargeting and writes the header. Returns
  /// false if the reader has closed the pipe. Throws Error for a rig that cannot be retargeted.
  bool take(const motion::BvhHead& head, const motion::Pose& pose);

  /// Whether a frame has been processed.
  bool has_begun() const { return stream_.has_value(); }

  /// Writes the remaining delayed frames and returns the summary. Throws Error if there were no
  /// frames.
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
  motion::Recording source_;  ///< all input frames, if measuring
  motion::Clip mapped_;       ///< all frames retargeted to the body, if measuring
  motion::Clip given_;        ///< all output frames, if measuring
};

}  // namespace mien::pipeline
