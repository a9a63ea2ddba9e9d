#include "pipeline/commands/motion/live_stream.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "motion/error.h"
#include "motion/formats/motion_format.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"

namespace mien::pipeline {

namespace {

constexpr int look_up_milliseconds = 100;  // interval for checking stop requests

/// Width reserved for the number of frames, which is known at the end.
constexpr std::size_t count_width = 12;

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Number of whole frames within the delay.
int frames_in(double delay_ms, double frames_per_second) {
  return static_cast<int>(std::floor(delay_ms * frames_per_second / 1000.0 + 1e-6));
}

}  // namespace

MotionSource::MotionSource(const std::string& file) : name_(file) {
  if (file == "-") {
    name_ = "standard input";
    descriptor_ = STDIN_FILENO;
    return;
  }
  if (std::filesystem::is_directory(file))
    throw Error(Place{file}, "is a folder", "name a BVH file, or - for standard input");
  const motion::MotionFormat* format = motion::motion_format(file);
  if (format != nullptr && !format->is_streamed)
    throw Error(Place{file}, "cannot be streamed, because this format must be read as a whole",
                "write it as BVH, with mien motion convert, or use mien motion modify");
  descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0)
    throw Error(Place{file}, std::string("cannot be read: ") + std::strerror(errno),
                "name a BVH file, or - for standard input");
}

MotionSource::~MotionSource() {
  if (descriptor_ > STDIN_FILENO) close(descriptor_);
}

std::optional<std::string> MotionSource::next(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    pollfd waiting{descriptor_, POLLIN, 0};
    if (poll(&waiting, 1, look_up_milliseconds) == 0) continue;
    std::array<char, 16384> bytes;
    const ssize_t count = read(descriptor_, bytes.data(), bytes.size());
    if (count > 0) return std::string(bytes.data(), static_cast<std::size_t>(count));
    if (count == 0) return std::nullopt;
    if (errno != EINTR && errno != EAGAIN)
      throw std::system_error(errno, std::generic_category(), "reading " + name_);
  }
  return std::nullopt;
}

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

LiveStream::LiveStream(LiveOptions options, MotionSink& sink)
    : options_(std::move(options)), sink_(sink) {
  motion::check_streamable(options_.modification);
}

void LiveStream::begin(const motion::BvhHead& head, const motion::Pose& pose) {
  const double rate = head.frames_per_second;
  source_ = {options_.name, "bvh", head.hierarchy.skeleton, rate, {pose}};
  if (options_.calibration) {
    mapping_.emplace(*options_.calibration, source_);
  } else {
    mapping_.emplace(source_);
  }
  source_.poses.clear();
  report_.frames_per_second = rate;
  report_.warnings = mapping_->mapping().warnings;
  if (options_.delay_ms) {
    report_.delay =
        motion::split_delay(frames_in(*options_.delay_ms, rate), options_.modification, rate);
  } else {
    report_.delay.paths = motion::shortest_look_ahead(options_.modification, rate);
  }
  const motion::Skeleton& body = mapping_->mapping().body;
  stream_.emplace(body, rate, options_.modification, report_.delay, options_.scope);
  if (options_.calibration)
    stream_->expect(motion::to_body(*options_.calibration, mapping_->mapping()));
  report_.delay = stream_->delay();
  mapped_.name = given_.name = options_.name;
  mapped_.body = given_.body = body;
  mapped_.frames_per_second = given_.frames_per_second = rate;
  sink_.begin(body, rate, head.claimed_frames);
}

bool LiveStream::take(const motion::BvhHead& head, const motion::Pose& pose) {
  if (!stream_) begin(head, pose);
  const Clock::time_point start = Clock::now();
  const motion::Pose mapped = (*mapping_)(pose);
  const std::optional<motion::Pose> given = stream_->push(mapped);
  const bool is_read = !given || put(*given);
  const double computing = milliseconds_since(start);
  ++report_.frames;
  report_.mean_computing_ms +=
      (computing - report_.mean_computing_ms) / static_cast<double>(report_.frames);
  report_.most_computing_ms = std::max(report_.most_computing_ms, computing);
  if (options_.measure) {
    source_.poses.push_back(pose);
    mapped_.poses.push_back(mapped);
  }
  return is_read;
}

bool LiveStream::put(const motion::Pose& pose) {
  if (options_.measure) given_.poses.push_back(pose);
  return sink_.put(pose);
}

LiveReport LiveStream::finish() {
  if (!stream_)
    throw Error(Place{options_.name}, "no frame came", "send at least one frame after Frame Time:");
  for (const motion::Pose& pose : stream_->finish())
    if (!put(pose)) break;
  report_.largest_lag = stream_->largest_lag();
  if (options_.measure && given_.poses.size() == mapped_.poses.size())
    report_.measured = measurement();
  return report_;
}

/// The result of offline processing: for the whole body that of `mien motion modify`.
motion::Clip LiveStream::whole_modified(motion::Modification modification) const {
  modification = motion::without_repair(std::move(modification));
  if (options_.scope == motion::PathScope::body) return motion::modified(mapped_, modification);
  const int all = mapped_.frame_count();
  return motion::streamed(mapped_, modification, {all, report_.delay.timing, all}, options_.scope);
}

LiveMeasurement LiveStream::measurement() const {
  LiveMeasurement measured;
  measured.error = motion::stream_error(given_, whole_modified(options_.modification));
  motion::Modification plain = options_.modification;
  plain.soft_joint_limits = false;
  plain.acceleration = 0.0;
  measured.of_paths_and_posture = motion::stream_error(
      motion::streamed(mapped_, plain, report_.delay, options_.scope), whole_modified(plain));
  measured.calibration = motion::stream_error(mapped_, motion::to_body(source_));
  const std::vector<motion::FootPlant> plants = motion::foot_plants(mapped_);
  measured.plants = static_cast<int>(plants.size());
  measured.drift_m = motion::planted_drift(given_, plants);
  measured.drift_of_source_m = motion::planted_drift(mapped_, plants);
  return measured;
}

}  // namespace mien::pipeline
