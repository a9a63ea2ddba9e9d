#include "motion/formats/bvh/bvh_hierarchy.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "motion/formats/reading/chosen_subject.h"
#include "motion/formats/reading/recording_limits.h"

namespace mien::motion {

namespace {

/// A joint whose closing brace has not come yet.
struct OpenJoint {
  int joint = -1;
  size_t place = 0;
  bool has_offset = false;
  bool has_channels = false;
};

std::optional<BvhChannel> channel_named(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, Axis>, 3> axes = {
      {{"X", Axis::x}, {"Y", Axis::y}, {"Z", Axis::z}}};
  for (const auto& [letter, axis] : axes) {
    if (!same_word(word.substr(0, 1), letter)) continue;
    if (same_word(word.substr(1), "position")) return BvhChannel{0, axis, false};
    if (same_word(word.substr(1), "rotation")) return BvhChannel{0, axis, true};
  }
  return std::nullopt;
}

void expect_brace(TextCursor& cursor, std::string_view brace, std::string_view after) {
  skip_space(cursor);
  const size_t place = cursor.at;
  const std::string_view word = next_word(cursor);
  if (word == brace) return;
  fail(cursor, place,
       "expected \"" + std::string(brace) + "\" after " + std::string(after) + ", found " +
           (word.empty() ? "the end" : in_quotes(word)),
       "check that the file is complete and its braces match");
}

/// Names may hold spaces: a name runs to the brace or the end of its line.
std::string parse_name(TextCursor& cursor, std::string_view keyword) {
  skip_space(cursor);
  const size_t start = cursor.at;
  while (!at_line_end(cursor) && cursor.text[cursor.at] != '{') ++cursor.at;
  std::string_view name = cursor.text.substr(start, cursor.at - start);
  while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
  if (name.empty()) {
    fail(cursor, start, std::string(keyword) + " has no name", "write the joint's name after it");
  }
  return std::string(name);
}

Vec3 parse_offset(TextCursor& cursor) {
  const double x = parse_number(cursor, "x of OFFSET");
  const double y = parse_number(cursor, "y of OFFSET");
  const double z = parse_number(cursor, "z of OFFSET");
  return {x, y, z};
}

Vec3 parse_end_site(TextCursor& cursor) {
  while (!at_end(cursor) && cursor.text[cursor.at] != '{') ++cursor.at;
  expect_brace(cursor, "{", "End Site");
  skip_space(cursor);
  const size_t place = cursor.at;
  if (!same_word(next_word(cursor), "OFFSET")) {
    fail(cursor, place, "End Site holds no OFFSET", "write \"OFFSET x y z\" between its braces");
  }
  const Vec3 tip = parse_offset(cursor);
  expect_brace(cursor, "}", "the OFFSET of End Site");
  return tip;
}

/// Where a comment begins in a line: at its start or after a blank. The rest of a line that names a
/// joint is its name.
size_t comment_in(std::string_view line) {
  TextCursor cursor = start_of(line, "");
  const std::string_view first = next_word(cursor);
  if (same_word(first, "ROOT") || same_word(first, "JOINT")) return std::string_view::npos;
  for (size_t i = 0; i < line.size(); ++i) {
    const bool is_free = i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t';
    if (is_free && (line[i] == '#' || line.substr(i, 2) == "//")) return i;
  }
  return std::string_view::npos;
}

class HierarchyReader {
 public:
  HierarchyReader(TextCursor& cursor, const BvhChoice& choice) : cursor_(cursor), choice_(choice) {}

  BvhHierarchy read() {
    expect_heading();
    while (parse_statement()) {
    }
    if (roots_.size() > 1) keep_one_figure();
    if (roots_.size() == 1) check_only_figure();
    return std::move(hierarchy_);
  }

 private:
  std::vector<Joint>& joints() { return hierarchy_.skeleton.joints; }

  void expect_heading() {
    skip_space(cursor_);
    const size_t place = cursor_.at;
    if (!same_word(next_word(cursor_), "HIERARCHY")) {
      fail(cursor_, place, "a BVH file starts with HIERARCHY", "check that this is a BVH file");
    }
  }

  /// False after MOTION.
  bool parse_statement() {
    skip_space(cursor_);
    const size_t place = cursor_.at;
    const std::string_view word = next_word(cursor_);
    if (open_.empty()) return parse_outer_statement(word, place);
    if (same_word(word, "OFFSET")) {
      parse_joint_offset(place);
    } else if (same_word(word, "CHANNELS")) {
      parse_channels(place);
    } else if (same_word(word, "JOINT")) {
      open_joint("JOINT", place);
    } else if (same_word(word, "End") || same_word(word, "EndSite")) {
      const Vec3 tip = parse_end_site(cursor_);
      Joint& joint = joints()[static_cast<size_t>(open_.back().joint)];
      if (!joint.tip) joint.tip = tip;
    } else if (word == "}") {
      close_joint();
    } else {
      refuse_in_joint(word, place);
    }
    return true;
  }

  bool parse_outer_statement(std::string_view word, size_t place) {
    if (same_word(word, "ROOT")) {
      if (!roots_.empty() && !choice_.may_choose) {
        fail(cursor_, place, "a second ROOT, but one figure alone can be streamed",
             "choose one as the subject, or stream each figure by itself");
      }
      roots_.push_back({joints().size(), place});
      open_joint("ROOT", place);
      return true;
    }
    if (same_word(word, "MOTION") && !joints().empty()) return false;
    const std::string expected = joints().empty() ? "ROOT" : "MOTION";
    fail(cursor_, place,
         "expected " + expected + ", found " + (word.empty() ? "the end" : in_quotes(word)),
         word.empty() ? "the file is truncated: obtain it again" : "check the braces above");
  }

  [[noreturn]] void refuse_in_joint(std::string_view word, size_t place) {
    const std::string name = in_quotes(joints()[static_cast<size_t>(open_.back().joint)].name);
    if (word.empty() || same_word(word, "MOTION")) {
      fail(cursor_, place, "joint " + name + " is not closed by \"}\"",
           word.empty() ? "the file is truncated: obtain it again" : "add the closing brace");
    }
    if (channel_named(word)) {
      fail(cursor_, place, "joint " + name + " names more channels than CHANNELS counts",
           "correct the count after CHANNELS");
    }
    fail(cursor_, place, "unknown word " + in_quotes(word) + " in joint " + name,
         "a joint holds OFFSET, CHANNELS, JOINT and End Site");
  }

  void open_joint(std::string_view keyword, size_t place) {
    Joint joint;
    joint.name = parse_name(cursor_, keyword);
    joint.parent = open_.empty() ? -1 : open_.back().joint;
    if (!is_reasonable_size(joints().size() + 1, 0))
      require_reasonable_size(place_at(cursor_, place), joints().size() + 1, 0);
    expect_brace(cursor_, "{", std::string(keyword) + " " + in_quotes(joint.name));
    open_.push_back({static_cast<int>(joints().size()), place});
    joints().push_back(std::move(joint));
  }

  void close_joint() {
    const OpenJoint& closed = open_.back();
    if (!closed.has_offset) {
      fail(
          cursor_, closed.place,
          "joint " + in_quotes(joints()[static_cast<size_t>(closed.joint)].name) + " has no OFFSET",
          "write \"OFFSET x y z\" between its braces");
    }
    open_.pop_back();
  }

  void parse_joint_offset(size_t place) {
    OpenJoint& joint = open_.back();
    if (std::exchange(joint.has_offset, true)) {
      fail(cursor_, place, "a second OFFSET in one joint", "remove one");
    }
    joints()[static_cast<size_t>(joint.joint)].offset = parse_offset(cursor_);
  }

  void parse_channels(size_t place) {
    OpenJoint& joint = open_.back();
    if (std::exchange(joint.has_channels, true)) {
      fail(cursor_, place, "a second CHANNELS in one joint", "remove one");
    }
    skip_space(cursor_);
    const size_t count_place = cursor_.at;
    const long count = parse_count(cursor_, "the number of channels");
    if (count > 6) {
      fail(cursor_, count_place, std::to_string(count) + " channels on one joint",
           "a joint has at most 6");
    }
    std::array<bool, 6> named = {};
    for (long i = 0; i < count; ++i) parse_channel(joint.joint, named);
  }

  void parse_channel(int joint, std::array<bool, 6>& named) {
    skip_space(cursor_);
    const size_t place = cursor_.at;
    const std::string_view word = next_word(cursor_);
    std::optional<BvhChannel> channel = channel_named(word);
    if (!channel) {
      fail(cursor_, place,
           "expected a channel name, found " + (word.empty() ? "the end" : in_quotes(word)),
           "channels are Xposition Yposition Zposition Xrotation Yrotation Zrotation, as many as "
           "CHANNELS counts");
    }
    const size_t which = static_cast<size_t>(channel->axis) + (channel->rotation ? 3 : 0);
    if (std::exchange(named[which], true)) {
      fail(cursor_, place, in_quotes(word) + " appears twice in one joint", "remove one");
    }
    channel->joint = joint;
    hierarchy_.channels.push_back(*channel);
  }

  void check_only_figure() const {
    chosen_subject(place_at(cursor_, roots_.front().place), {hierarchy_.skeleton.joints[0].name},
                   choice_.subject);
  }

  /// The joints of a figure follow each other, up to the next root.
  void keep_one_figure() {
    std::vector<std::string> names;
    for (const Root& root : roots_) names.push_back(joints()[root.joint].name);
    hierarchy_.subjects = subject_names(names);
    hierarchy_.chosen =
        chosen_subject(place_at(cursor_, roots_[1].place), hierarchy_.subjects, choice_.subject);
    const bool is_last = hierarchy_.chosen + 1 == roots_.size();
    const size_t first = roots_[hierarchy_.chosen].joint;
    const size_t end = is_last ? joints().size() : roots_[hierarchy_.chosen + 1].joint;
    std::vector<Joint> kept(std::make_move_iterator(joints().begin() + static_cast<long>(first)),
                            std::make_move_iterator(joints().begin() + static_cast<long>(end)));
    for (Joint& joint : kept) joint.parent = std::max(joint.parent - static_cast<int>(first), -1);
    joints() = std::move(kept);
    for (BvhChannel& channel : hierarchy_.channels) {
      const auto joint = static_cast<size_t>(channel.joint);
      channel.joint = joint >= first && joint < end ? static_cast<int>(joint - first) : -1;
    }
  }

  struct Root {
    size_t joint = 0;
    size_t place = 0;
  };

  TextCursor& cursor_;
  const BvhChoice& choice_;
  BvhHierarchy hierarchy_;
  std::vector<Root> roots_;
  std::vector<OpenJoint> open_;
};

}  // namespace

std::string without_bvh_comments(std::string_view text) {
  std::string plain(text);
  size_t start = 0;
  while (start < plain.size()) {
    const size_t end = std::min(plain.find_first_of("\r\n", start), plain.size());
    const size_t comment = comment_in(std::string_view(plain).substr(start, end - start));
    if (comment != std::string_view::npos) {
      std::fill(plain.begin() + static_cast<long>(start + comment),
                plain.begin() + static_cast<long>(end), ' ');
    }
    start = end + 1;
  }
  return plain;
}

BvhHierarchy parse_bvh_hierarchy(TextCursor& cursor, const BvhChoice& choice) {
  return HierarchyReader(cursor, choice).read();
}

bool has_channels(const BvhHierarchy& hierarchy) {
  return std::ranges::any_of(hierarchy.channels, [](const BvhChannel& c) { return c.joint >= 0; });
}

}  // namespace mien::motion
