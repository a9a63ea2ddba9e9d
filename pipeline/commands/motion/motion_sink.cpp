#include "pipeline/commands/motion/motion_sink.h"

#include <cerrno>
#include <system_error>
#include <utility>

namespace mien::pipeline {

namespace {

/// Room for any number of frames that is known at the end.
constexpr std::size_t count_width = 12;

}  // namespace

MotionSink::MotionSink(std::ostream& out, std::filesystem::path file, Form form)
    : out_(out), file_(std::move(file)), form_(form) {}

void MotionSink::begin(const motion::Skeleton& body, double frames_per_second,
                       std::size_t claimed_frames) {
  text_.emplace(body);
  std::string count = std::to_string(claimed_frames);
  if (has_file()) {
    unfinished_.emplace(file_);
    in_file_.open(unfinished_->draft(), std::ios::binary | std::ios::trunc);
    if (!in_file_) throw cannot_be_written(file_, {errno, std::generic_category()});
    count = "0" + std::string(count_width - 1, ' ');
  }
  if (form_ == Form::lines) return;
  const std::string head = text_->head(count, frames_per_second);
  constexpr std::string_view label = "\nFrames: ";
  count_place_ = static_cast<std::streamoff>(head.rfind(label) + label.size());
  (has_file() ? in_file_ : out_) << head;
  flushed();
}

bool MotionSink::put(const motion::Pose& pose) {
  line_.clear();
  text_->append_frame(line_, pose);
  (has_file() ? in_file_ : out_) << line_;
  ++frames_;
  return flushed();
}

bool MotionSink::flushed() {
  std::ostream& out = has_file() ? in_file_ : out_;
  out.flush();
  if (has_file() && !out) throw cannot_be_written(file_, {errno, std::generic_category()});
  return static_cast<bool>(out);
}

void MotionSink::publish() {
  if (!unfinished_) return;
  if (form_ == Form::bvh) {
    in_file_.seekp(count_place_);
    in_file_ << frames_;
  }
  flushed();
  in_file_.close();
  unfinished_->publish();
  unfinished_.reset();
}

}  // namespace mien::pipeline
