#include <algorithm>

#include "motion/formats/bvh/bvh.h"
#include "motion/formats/bvh/bvh_frames.h"
#include "motion/formats/reading/chosen_subject.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

std::vector<Pose> parse_frames(TextCursor& cursor, const BvhHierarchy& hierarchy, size_t count,
                               size_t count_place) {
  const Pose before = bvh_pose_before_channels(hierarchy);
  // The count is only a claim: what can be there is at least two characters a number.
  const size_t possible = (cursor.text.size() - cursor.at) / (2 * hierarchy.channels.size()) + 1;
  std::vector<Pose> poses;
  poses.reserve(std::min(count, possible));
  for (skip_space(cursor); !at_end(cursor); skip_space(cursor)) {
    if (poses.size() == count) {
      fail(cursor, cursor.at, "more frames than the " + std::to_string(count) + " of \"Frames:\"",
           "correct the number after Frames: or remove the surplus");
    }
    poses.push_back(before);
    parse_bvh_frame(cursor, hierarchy, poses.back());
  }
  if (poses.size() < count) {
    fail(cursor, count_place,
         "\"Frames:\" says " + std::to_string(count) + ", but the file holds " +
             std::to_string(poses.size()),
         "correct the number, or obtain the file again if it is truncated");
  }
  return poses;
}

}  // namespace

Recording parse_bvh(std::string_view text, const std::string& file_name,
                    const ReadOptions& options) {
  const std::string plain = without_bvh_comments(text);
  TextCursor cursor = start_of(plain, file_name);
  BvhHierarchy hierarchy = parse_bvh_hierarchy(cursor, {.subject = options.subject});
  const auto [count, count_place] = parse_bvh_frame_count(cursor);
  if (count == 0) {
    fail(cursor, count_place, "there are no frames", "give a motion of at least one frame");
  }
  if (!has_channels(hierarchy)) {
    fail(cursor, count_place, "no joint has channels", "give the joints CHANNELS");
  }
  require_reasonable_size(place_at(cursor, count_place), hierarchy.skeleton.joints.size(), count);
  Recording recording;
  recording.name = recording_name(file_name);
  recording.format = "bvh";
  recording.frames_per_second = parse_bvh_frame_rate(cursor, options.frames_per_second);
  recording.poses = parse_frames(cursor, hierarchy, count, count_place);
  recording.skeleton = std::move(hierarchy.skeleton);
  recording.subjects = hierarchy.subjects;
  if (!hierarchy.subjects.empty()) recording.subject = hierarchy.subjects[hierarchy.chosen];
  std::string note = note_on_subject(hierarchy.subjects, hierarchy.chosen, options.subject);
  if (!note.empty()) recording.notes.push_back(std::move(note));
  return recording;
}

Recording read_bvh(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string text = read_contents(path);
  require_kind(text, path.string(), "bvh");
  return parse_bvh(text, path.string(), options);
}

}  // namespace mien::motion
