#include "motion/formats/bvh/bvh_stream.h"

#include <algorithm>

#include "motion/formats/bvh/bvh_frames.h"
#include "motion/formats/reading/recording_limits.h"

namespace mien::motion {

namespace {

constexpr size_t longest_head = size_t{4} << 20;
constexpr size_t longest_number = 64;
constexpr size_t longest_rest = 4096;

size_t words_in(std::string_view line) {
  TextCursor cursor{line, ""};
  size_t words = 0;
  while (!next_word_on_line(cursor).empty()) ++words;
  return words;
}

/// Whether the line holds the label of the frame time, and whether a number follows there.
bool is_frame_time(std::string_view line) {
  TextCursor cursor{line, ""};
  if (!same_word(next_word_on_line(cursor), "Frame")) return false;
  return same_word(next_word_on_line(cursor).substr(0, 4), "Time");
}

bool has_digit(std::string_view line) {
  return line.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

void BvhStream::push(std::string_view piece) { text_ += piece; }

void BvhStream::finish() {
  finished_ = true;
  if (!head_) read_head();
}

/// The next whole line of the text that has not been looked at, with its end.
std::optional<std::string_view> BvhStream::next_line() {
  size_t end = text_.find_first_of("\r\n", seen_);
  if (end == std::string::npos) {
    if (!finished_ || seen_ == text_.size()) return std::nullopt;
    end = text_.size();
  } else if (text_[end] == '\r' && end + 1 == text_.size() && !finished_) {
    return std::nullopt;  // the second half of the line's end may be on its way
  } else {
    end += text_.compare(end, 2, "\r\n") == 0 ? 2 : 1;
  }
  const std::string_view line = std::string_view(text_).substr(seen_, end - seen_);
  seen_ = end;
  return line;
}

void BvhStream::drop(size_t count) {
  const TextCursor cursor{text_, file_, 0, first_line_};
  first_line_ = place_at(cursor, count).line;
  text_.erase(0, count);
  seen_ -= std::min(count, seen_);
}

/// Once all lines of the head have come, or nothing more comes.
void BvhStream::read_head() {
  const std::string plain = without_bvh_comments(text_);
  TextCursor cursor = start_of(plain, file_);
  const size_t mark = text_.size() - cursor.text.size();
  BvhHead head;
  head.hierarchy =
      parse_bvh_hierarchy(cursor, {.subject = subject_, .may_choose = subject_.has_value()});
  const auto [frames, place] = parse_bvh_frame_count(cursor);
  head.claimed_frames = frames;
  if (head.hierarchy.channels.empty()) {
    fail(cursor, place, "no joint has channels", "give the joints CHANNELS");
  }
  require_reasonable_size(place_at(cursor, place), head.hierarchy.skeleton.joints.size(), 1);
  head.frames_per_second = parse_bvh_frame_rate(cursor);
  before_ = bvh_pose_before_channels(head.hierarchy);
  head_ = std::move(head);
  drop(mark + cursor.at);
  seen_ = 0;
}

std::optional<Pose> BvhStream::next() {
  while (!head_) {
    const auto line = next_line();
    if (!line) {
      if (text_.size() <= longest_head) return std::nullopt;
      const TextCursor cursor{text_, file_};
      fail(cursor, longest_head, "there is no \"Frame Time:\" in the first 4 MiB",
           "send the hierarchy, MOTION, Frames: and Frame Time: before the frames");
    }
    const std::string plain = without_bvh_comments(*line);
    if (!knows_kind_ && words_in(plain) > 0) {
      knows_kind_ = true;
      TextCursor cursor = start_of(plain, file_);
      if (!same_word(next_word(cursor), "HIERARCHY")) read_head();  // says what is wrong, and where
    }
    has_label_ = has_label_ || is_frame_time(plain);
    if (has_label_ && has_digit(plain)) read_head();
  }
  const size_t channels = head_->hierarchy.channels.size();
  while (const auto line = next_line()) {
    const size_t words = words_in(without_bvh_comments(*line));
    if (words == 0 && numbers_ == 0) {
      drop(seen_);
      continue;
    }
    numbers_ += words;
    if (numbers_ < channels) continue;
    const std::string plain = without_bvh_comments(std::string_view(text_).substr(0, seen_));
    TextCursor cursor{plain, file_, 0, first_line_};
    skip_space(cursor);
    Pose pose = before_;
    parse_bvh_frame(cursor, head_->hierarchy, pose);
    numbers_ = 0;
    drop(seen_);
    return pose;
  }
  const TextCursor cursor{text_, file_, 0, first_line_};
  if (text_.size() > longest_number * channels + longest_rest) {
    fail(cursor, 0, "this frame is incomplete", "end each frame with a line break");
  }
  if (finished_ && numbers_ > 0) {
    const std::string plain = without_bvh_comments(text_);
    TextCursor rest{plain, file_, 0, first_line_};
    Pose pose = before_;
    parse_bvh_frame(rest, head_->hierarchy, pose);  // says that the text was cut short
  }
  return std::nullopt;
}

}  // namespace mien::motion
