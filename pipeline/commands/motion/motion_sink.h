#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>

#include "motion/formats/bvh_text.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

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

}  // namespace mien::pipeline
