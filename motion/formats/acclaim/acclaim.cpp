#include "motion/formats/acclaim/acclaim.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "motion/formats/acclaim/acclaim_skeleton.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

constexpr double cmu_rate = 120.0;  // of the CMU database

class AmcReader {
 public:
  AmcReader(const NamedText& amc, const AcclaimSkeleton& skeleton)
      : cursor_(start_of(amc.text, amc.file_name)),
        skeleton_(skeleton),
        radians_per_unit_(skeleton.radians_per_unit),
        last_frame_with_(skeleton.bones.size(), -1) {
    for (size_t j = 0; j < skeleton.bones.size(); ++j) {
      bone_named_.emplace(skeleton.skeleton.joints[j].name, j);
    }
  }

  std::vector<Pose> read() {
    while (!at_end(cursor_)) {
      parse_line();
      skip_line(cursor_);
    }
    if (poses_.empty()) {
      fail(cursor_, cursor_.at, "there are no frames", "give a motion of at least one frame");
    }
    require_all_bones();
    return std::move(poses_);
  }

  std::optional<double> samples_per_second() const { return samples_per_second_; }

 private:
  void parse_line() {
    skip_blanks(cursor_);
    const size_t place = cursor_.at;
    const std::string_view word = next_word_on_line(cursor_);
    if (word.empty() || word.starts_with('#')) return;
    if (word.starts_with(':')) return parse_keyword(word, place);
    skip_blanks(cursor_);
    const bool is_number = word.find_first_not_of("0123456789") == std::string_view::npos;
    if (is_number && at_line_end(cursor_)) {
      cursor_.at = place;
      return start_frame();
    }
    parse_bone(word, place);
  }

  void parse_keyword(std::string_view word, size_t place) {
    if (!poses_.empty()) {
      fail(cursor_, place, in_quotes(word) + " appears after the first frame",
           "put it at the head of the file");
    }
    if (same_word(word, ":DEGREES")) radians_per_unit_ = radians_per_degree;
    if (same_word(word, ":RADIANS")) radians_per_unit_ = 1.0;
    if (same_word(word, ":SAMPLES-PER-SECOND")) parse_rate();
  }

  void parse_rate() {
    skip_blanks(cursor_);
    const size_t place = cursor_.at;
    const double rate = at_line_end(cursor_) ? 0.0 : parse_number(cursor_, "samples per second");
    if (!(rate >= 1e-3 && rate <= 1e5)) {
      fail(cursor_, place, "the samples per second are not usable", "a common value is 120");
    }
    samples_per_second_ = rate;
  }

  void start_frame() {
    const size_t place = cursor_.at;
    const long number = parse_count(cursor_, "the number of a frame");
    if (!poses_.empty()) {
      require_all_bones();
      if (number != frame_number_ + 1) {
        fail(cursor_, place,
             "frame " + std::to_string(number) + " follows frame " + std::to_string(frame_number_),
             "frames count up by one: restore the missing ones or renumber");
      }
    }
    frame_number_ = number;
    frame_place_ = place;
    const size_t joints = skeleton_.bones.size();
    if (!is_reasonable_size(joints, poses_.size() + 1)) {
      require_reasonable_size(place_at(cursor_, place), joints, poses_.size() + 1);
    }
    poses_.emplace_back();
    poses_.back().root_position = skeleton_.skeleton.joints.front().offset;
    poses_.back().rotations.assign(joints, Quat::Identity());
  }

  void require_all_bones() {
    const auto frame = static_cast<long>(poses_.size()) - 1;
    for (size_t j = 0; j < skeleton_.bones.size(); ++j) {
      if (skeleton_.bones[j].freedoms.empty() || last_frame_with_[j] == frame) continue;
      fail(cursor_, frame_place_,
           "frame " + std::to_string(frame_number_) + " lacks bone " +
               in_quotes(skeleton_.skeleton.joints[j].name),
           "obtain the file again if it is truncated, or check that the skeleton belongs to it");
    }
  }

  void parse_bone(std::string_view name, size_t place) {
    if (poses_.empty()) {
      fail(cursor_, place, "expected the number of the first frame, found " + in_quotes(name),
           "check that this is an AMC file");
    }
    const auto found = bone_named_.find(std::string(name));
    if (found == bone_named_.end()) {
      fail(cursor_, place, "the skeleton has no bone " + in_quotes(name),
           "check that the ASF file belongs to this motion");
    }
    const size_t bone = found->second;
    const auto frame = static_cast<long>(poses_.size()) - 1;
    if (last_frame_with_[bone] == frame) {
      fail(cursor_, place,
           "bone " + in_quotes(name) + " appears twice in frame " + std::to_string(frame_number_),
           "remove one of the lines");
    }
    last_frame_with_[bone] = frame;
    parse_freedoms(bone, poses_.back());
  }

  void parse_freedoms(size_t bone, Pose& pose) {
    const AcclaimBone& moves = skeleton_.bones[bone];
    Quat turned = Quat::Identity();
    for (size_t i = 0; i < moves.freedoms.size(); ++i) {
      skip_blanks(cursor_);
      if (at_line_end(cursor_)) refuse_count(bone, std::to_string(i) + " numbers");
      const double value = parse_number(cursor_, "one per degree of freedom");
      const int axis = moves.freedoms[i].axis;
      if (moves.freedoms[i].rotation) {
        turned = Quat(Eigen::AngleAxisd(value * radians_per_unit_, Vec3::Unit(axis))) * turned;
      } else {
        pose.root_position[axis] += value * skeleton_.metres_per_unit;
      }
    }
    skip_blanks(cursor_);
    if (!at_line_end(cursor_)) refuse_count(bone, "more numbers");
    pose.rotations[bone] = (moves.axis * turned * moves.axis.conjugate()).normalized();
  }

  [[noreturn]] void refuse_count(size_t bone, const std::string& numbers) {
    fail(cursor_, cursor_.at,
         "bone " + in_quotes(skeleton_.skeleton.joints[bone].name) + " has " + numbers +
             ", its degrees of freedom are " +
             std::to_string(skeleton_.bones[bone].freedoms.size()),
         at_end(cursor_) ? "the file is truncated: obtain it again"
                         : "give one number for each degree of freedom that the skeleton lists");
  }

  TextCursor cursor_;
  const AcclaimSkeleton& skeleton_;
  double radians_per_unit_;
  std::unordered_map<std::string, size_t> bone_named_;
  std::vector<long> last_frame_with_;  ///< index of the last frame that had each bone
  std::optional<double> samples_per_second_;
  std::vector<Pose> poses_;
  long frame_number_ = 0;
  size_t frame_place_ = 0;
};

/// Subject and, in some collections, the motion's own name: "02" and "02_01" for 02_01.amc.
std::array<std::string, 2> skeleton_names(const std::filesystem::path& amc) {
  const std::string stem = recording_name(amc);
  return {stem.substr(0, stem.rfind('_')), stem};
}

bool has_name_for(const std::filesystem::path& asf, const std::filesystem::path& amc) {
  return std::ranges::count(skeleton_names(amc), recording_name(asf)) > 0;
}

std::vector<std::filesystem::path> asf_files_beside(const std::filesystem::path& amc) {
  const std::filesystem::path folder = amc.has_parent_path() ? amc.parent_path() : ".";
  std::vector<std::filesystem::path> files;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure)) {
    if (same_word(without_compression(entry.path()).extension().string(), ".asf"))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::filesystem::path find_asf(const std::filesystem::path& amc) {
  const std::array<std::string, 2> names = skeleton_names(amc);
  const std::string& subject = names.front();
  const std::vector<std::filesystem::path> files = asf_files_beside(amc);
  for (const std::string& wanted : names) {
    for (const std::filesystem::path& file : files) {
      if (recording_name(file) == wanted) return file;
    }
  }
  if (files.size() == 1) return files.front();
  throw Error({amc.string()},
              files.empty()
                  ? "there is no skeleton (.asf) beside this motion"
                  : "there are several skeletons (.asf) beside this motion, none with its name",
              "put " + subject + ".asf into the same folder");
}

Recording parse_amc(const NamedText& amc, const NamedText& asf,
                    std::optional<double> frames_per_second) {
  AcclaimSkeleton skeleton = parse_asf(asf.text, asf.file_name);
  AmcReader reader(amc, skeleton);
  Recording recording;
  recording.name = recording_name(amc.file_name);
  recording.format = "amc";
  recording.poses = reader.read();
  recording.frames_per_second =
      reader.samples_per_second().value_or(frames_per_second.value_or(cmu_rate));
  recording.skeleton = std::move(skeleton.skeleton);
  return recording;
}

Recording read_amc(const std::filesystem::path& path, const AcclaimOptions& options) {
  const std::string amc = read_contents(path);
  require_kind(amc, path.string(), "amc");
  const std::filesystem::path skeleton = options.skeleton ? *options.skeleton : find_asf(path);
  const std::string asf = read_contents(skeleton);
  require_kind(asf, skeleton.string(), "amc");
  Recording recording =
      parse_amc({amc, path.string()}, {asf, skeleton.string()}, options.frames_per_second);
  if (!options.skeleton && !has_name_for(skeleton, path)) {
    recording.notes.push_back(
        "The skeleton is that of " + skeleton.filename().string() +
        ", whose name differs from the motion's; it is the only one in the folder.");
  }
  return recording;
}

}  // namespace mien::motion
