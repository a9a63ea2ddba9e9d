#include "motion/formats/mvnx/mvnx.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "motion/formats/mvnx/mvnx_hands.h"
#include "motion/formats/mvnx/mvnx_skeleton.h"
#include "motion/formats/reading/chosen_subject.h"
#include "motion/formats/reading/frame_rate.h"
#include "motion/formats/reading/option_names.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

std::string short_number(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  std::string written = text;
  std::ranges::replace(written, ',', '.');  // as some locales write it
  return written;
}

/// The numbers of one person, checked, in the order of a tree of segments.
struct SegmentMotion {
  const MvnxSubject& subject;
  const MvnxTree& tree;

  std::size_t segments() const { return tree.segments.size(); }
  std::size_t frames() const { return subject.frames.size(); }

  Quat rotation(std::size_t frame, std::size_t t) const {
    const double* q =
        &subject.orientations[4 * (frame * subject.segments.size() + tree.segments[t])];
    return Quat(q[0], q[1], q[2], q[3]).normalized();
  }
  Vec3 position(std::size_t frame, std::size_t t) const {
    return Vec3(&subject.positions[3 * (frame * subject.segments.size() + tree.segments[t])]);
  }
  /// Position in the frame of the parent, which there is.
  Vec3 offset(std::size_t frame, std::size_t t) const {
    const auto parent = static_cast<std::size_t>(tree.parents[t]);
    return rotation(frame, parent).conjugate() * (position(frame, t) - position(frame, parent));
  }
};

/// The number of segments of a frame.
std::size_t require_frames(const TextCursor& cursor, const MvnxSubject& subject) {
  if (subject.frames.empty())
    fail(cursor, subject.place, "there are no frames of type \"normal\"",
         "export the motion, not the calibration alone");
  const std::size_t frames = subject.frames.size();
  if (subject.positions.empty())
    fail(cursor, subject.frames.front(), "the frames have no positions of the segments",
         "export positions as well as orientations");
  const std::size_t count = subject.orientations.size() / frames / 4;
  if (count * frames * 4 != subject.orientations.size() ||
      count * frames * 3 != subject.positions.size())
    fail(cursor, subject.frames.front(),
         "a frame has " + std::to_string(subject.orientations.size() / frames) +
             " numbers of orientation and " + std::to_string(subject.positions.size() / frames) +
             " of position",
         "there are to be four and three of them for each segment: export the file again");
  if (!subject.segments.empty() && subject.segments.size() != count)
    fail(cursor, subject.frames.front(),
         "a frame has " + std::to_string(count) + " segments, but " +
             std::to_string(subject.segments.size()) + " are listed",
         "export the file again");
  return count;
}

void require_rotations(const TextCursor& cursor, const MvnxSubject& subject) {
  const std::size_t count = subject.segments.size();
  for (std::size_t i = 0; i < subject.orientations.size(); i += 4) {
    const double* q = &subject.orientations[i];
    if (std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) > 1e-3) continue;
    const std::size_t frame = i / 4 / count;
    fail(cursor, subject.frames[frame],
         "the orientation of " + in_quotes(subject.segments[i / 4 % count].label) + " in frame " +
             std::to_string(frame + 1) + " is of length zero",
         "export the file again");
  }
}

double middle_of(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + static_cast<long>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

Vec3 median_offset(const SegmentMotion& motion, std::size_t t) {
  std::vector<double> x, y, z;
  for (std::size_t f = 0; f < motion.frames(); ++f) {
    const Vec3 offset = motion.offset(f, t);
    x.push_back(offset.x());
    y.push_back(offset.y());
    z.push_back(offset.z());
  }
  return {middle_of(x), middle_of(y), middle_of(z)};
}

Skeleton skeleton_of(const SegmentMotion& motion) {
  Skeleton skeleton;
  for (std::size_t t = 0; t < motion.segments(); ++t) {
    Joint joint;
    joint.name = motion.subject.segments[motion.tree.segments[t]].label;
    joint.parent = motion.tree.parents[t];
    if (joint.parent >= 0) joint.offset = median_offset(motion, t);
    if (joint.name.empty()) joint.name = "segment_" + std::to_string(motion.tree.segments[t] + 1);
    skeleton.joints.push_back(std::move(joint));
  }
  const auto children = children_of(skeleton);
  for (std::size_t t = 0; t < motion.segments(); ++t) {
    if (children[t].empty())
      skeleton.joints[t].tip = motion.subject.segments[motion.tree.segments[t]].farthest_point;
  }
  return skeleton;
}

std::vector<Pose> poses_of(const SegmentMotion& motion) {
  std::vector<Pose> poses(motion.frames());
  for (std::size_t f = 0; f < poses.size(); ++f) {
    poses[f].root_position = motion.position(f, 0);
    poses[f].rotations.reserve(motion.segments());
    for (std::size_t t = 0; t < motion.segments(); ++t) {
      const int parent = motion.tree.parents[t];
      const Quat world = motion.rotation(f, t);
      poses[f].rotations.push_back(
          parent < 0 ? world
                     : motion.rotation(f, static_cast<std::size_t>(parent)).conjugate() * world);
    }
  }
  return poses;
}

/// Says where the bones of the file are not as long in all frames.
void note_loose_joints(const SegmentMotion& motion, Recording& recording) {
  constexpr double much = 0.01;
  double farthest = 0.0;
  std::size_t loosest = 0;
  for (std::size_t t = 1; t < motion.segments(); ++t) {
    for (std::size_t f = 0; f < motion.frames(); ++f) {
      const double away = (motion.offset(f, t) - recording.skeleton.joints[t].offset).norm();
      if (away > farthest) loosest = t;
      farthest = std::max(farthest, away);
    }
  }
  if (farthest <= much) return;
  recording.notes.push_back("The segments move against each other, " +
                            in_quotes(recording.skeleton.joints[loosest].name) + " by up to " +
                            short_number(100.0 * farthest) +
                            " cm; bones of constant length are used.");
}

/// Frames per second of the frames' times; 0 if there are none that increase.
double rate_of_times(const std::vector<double>& milliseconds) {
  if (milliseconds.size() < 2) return 0.0;
  const double seconds = (milliseconds.back() - milliseconds.front()) / 1000.0;
  const double rate = static_cast<double>(milliseconds.size() - 1) / seconds;
  return seconds > 0.0 && rate >= 0.1 && rate <= 1e5 ? snapped_frame_rate(rate) : 0.0;
}

/// Whether most of the steps of the times, which are whole milliseconds, are of that rate.
bool are_steps_of(double rate, const std::vector<double>& milliseconds) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < milliseconds.size(); ++i)
    steps.push_back(milliseconds[i] - milliseconds[i - 1]);
  return std::abs(middle_of(steps) - 1000.0 / rate) <= 1.0;
}

void set_frame_rate(const TextCursor& cursor, const MvnxSubject& subject,
                    const ReadOptions& options, Recording& recording) {
  const double stated = subject.frame_rate;
  const double timed = rate_of_times(subject.times);
  if (stated != 0.0 && !(stated >= 0.1 && stated <= 1e5))
    fail(cursor, subject.place, "a frame rate of " + short_number(stated) + " Hz",
         "state the frames per second as frameRate");
  if (timed > 0.0 && stated > 0.0 && !are_steps_of(stated, subject.times)) {
    recording.frames_per_second = timed;
    recording.notes.push_back("The file states " + short_number(stated) +
                              " Hz, but its times advance as at " + short_number(timed) +
                              " Hz, which is used.");
  } else if (stated > 0.0) {
    recording.frames_per_second = stated;
  } else if (timed > 0.0) {
    recording.frames_per_second = timed;
    recording.notes.push_back(
        "The file does not state its frame rate; that of the frames' times, " +
        short_number(timed) + " Hz, is used.");
  } else if (options.frames_per_second) {
    recording.frames_per_second = *options.frames_per_second;
  } else {
    fail(cursor, subject.place, "the frame rate is not stated",
         std::string("give it with ") + rate_option);
  }
}

Recording recording_of(const TextCursor& cursor, MvnxSubject& subject, const ReadOptions& options) {
  const std::size_t count = require_frames(cursor, subject);
  require_reasonable_size(place_at(cursor, subject.place), count, subject.frames.size());
  const bool is_named = !subject.segments.empty();
  name_segments(cursor, count, subject);
  Recording recording;
  add_tracked_hands(subject, recording.notes);
  require_reasonable_size(place_at(cursor, subject.place), subject.segments.size(),
                          subject.frames.size());
  require_rotations(cursor, subject);
  const MvnxTree tree = mvnx_tree(cursor, subject);
  const SegmentMotion motion{subject, tree};
  recording.name = recording_name(cursor.file);
  recording.format = "mvnx";
  set_frame_rate(cursor, subject, options, recording);
  if (!is_named)
    recording.notes.push_back(
        "The file does not name its segments; they are taken to be the 23 of MVN in their order.");
  if (!tree.left_out.empty())
    recording.notes.push_back(
        "Segments that are connected to no other are left out: " + listed(tree.left_out) + ".");
  recording.skeleton = skeleton_of(motion);
  recording.poses = poses_of(motion);
  note_loose_joints(motion, recording);
  return recording;
}

}  // namespace

Recording parse_mvnx(std::string_view text, const std::string& file_name,
                     const ReadOptions& options) {
  std::vector<MvnxSubject> people = parse_mvnx_subjects(text, file_name);
  const TextCursor cursor{text, file_name};
  std::vector<std::string> labels;
  for (const MvnxSubject& person : people) labels.push_back(person.label);
  const std::vector<std::string> names = subject_names(labels);
  const std::size_t chosen =
      chosen_subject(place_at(cursor, people.front().place), names, options.subject);
  Recording recording = recording_of(cursor, people[chosen], options);
  const bool is_told = names.size() > 1 || !labels.front().empty();
  if (is_told) recording.subjects = names;
  if (is_told) recording.subject = names[chosen];
  std::string note = note_on_subject(names, chosen, options.subject);
  if (!note.empty()) recording.notes.insert(recording.notes.begin(), std::move(note));
  return recording;
}

Recording read_mvnx(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string text = read_contents(path);
  require_kind(text, path.string(), "mvnx");
  return parse_mvnx(text, path.string(), options);
}

}  // namespace mien::motion
