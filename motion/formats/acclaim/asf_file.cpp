#include "motion/formats/acclaim/asf_file.h"

#include <unordered_map>

#include "motion/formats/reading/recording_limits.h"

namespace mien::motion {

namespace {

constexpr std::string_view root_name = "root";

bool is_comment_or_empty(TextCursor& cursor) {
  skip_blanks(cursor);
  return at_line_end(cursor) || cursor.text[cursor.at] == '#';
}

std::optional<AcclaimFreedom> freedom_named(std::string_view word) {
  if (word.size() != 2) return std::nullopt;
  constexpr std::string_view letters = "xyz";
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view letter = letters.substr(static_cast<size_t>(axis), 1);
    if (!same_word(word.substr(1), letter)) continue;
    if (same_word(word.substr(0, 1), "r")) return AcclaimFreedom{axis, true};
    if (same_word(word.substr(0, 1), "t")) return AcclaimFreedom{axis, false};
  }
  return std::nullopt;
}

class AsfReader {
 public:
  explicit AsfReader(TextCursor& cursor) : cursor_(cursor) {
    AsfBone root;
    root.name = root_name;
    root.axis = AsfAxis{};
    for (const bool rotation : {false, true}) {
      for (int axis = 0; axis < 3; ++axis) root.freedoms.push_back({axis, rotation});
    }
    file_.bones.push_back(std::move(root));
  }

  AsfFile read() {
    while (!at_end(cursor_)) parse_section();
    if (!has_hierarchy_) {
      fail(cursor_, cursor_.at, "there is no :hierarchy", "check that this is a complete ASF file");
    }
    return std::move(file_);
  }

 private:
  AsfBone& root() { return file_.bones.front(); }

  /// A line that starts with a colon and what follows, up to the next such line.
  void parse_section() {
    if (is_comment_or_empty(cursor_)) return skip_line(cursor_);
    const size_t place = cursor_.at;
    const std::string_view word = next_word_on_line(cursor_);
    if (!word.starts_with(':')) {
      fail(cursor_, place, "expected a section such as :bonedata, found " + in_quotes(word),
           "check that this is an ASF file");
    }
    skip_line(cursor_);
    if (same_word(word, ":units")) return parse_lines([&](auto key, size_t at) { unit(key, at); });
    if (same_word(word, ":root")) return parse_lines([&](auto key, size_t at) { root(key, at); });
    if (same_word(word, ":bonedata")) return parse_bones();
    if (same_word(word, ":hierarchy")) return parse_hierarchy();
    skip_section();
  }

  bool section_ends() {
    skip_blanks(cursor_);
    return at_end(cursor_) || cursor_.text[cursor_.at] == ':';
  }

  void skip_section() {
    while (!section_ends()) skip_line(cursor_);
  }

  /// Calls `take(first word, its place)` for every line of a section.
  template <typename Take>
  void parse_lines(Take take) {
    while (!section_ends()) {
      if (!is_comment_or_empty(cursor_)) {
        const size_t place = cursor_.at;
        take(next_word_on_line(cursor_), place);
      }
      skip_line(cursor_);
    }
  }

  double number(std::string_view meaning) {
    skip_blanks(cursor_);
    if (at_line_end(cursor_)) {
      fail(cursor_, cursor_.at, "expected a number, " + std::string(meaning), "complete this line");
    }
    return parse_number(cursor_, meaning);
  }

  Vec3 vector(std::string_view meaning) {
    const double x = number(meaning);
    const double y = number(meaning);
    return {x, y, number(meaning)};
  }

  void unit(std::string_view key, size_t place) {
    if (same_word(key, "length")) {
      const double length = number("the unit of length");
      if (!(length > 1e-9)) {
        fail(cursor_, place, "the unit of length is not positive", "CMU files say length 0.45");
      }
      file_.length_unit = length;
    } else if (same_word(key, "angle")) {
      skip_blanks(cursor_);
      const size_t at = cursor_.at;
      const std::string_view word = next_word_on_line(cursor_);
      if (same_word(word, "rad") || same_word(word, "radians")) {
        file_.radians_per_unit = 1.0;
      } else if (!same_word(word, "deg") && !same_word(word, "degrees")) {
        fail(cursor_, at, "unknown unit of angles " + in_quotes(word), "write deg or rad");
      }
    }
  }

  void root(std::string_view key, size_t) {
    if (same_word(key, "order")) {
      root().freedoms = freedoms();
    } else if (same_word(key, "axis")) {
      root().axis->order = axis_order();
    } else if (same_word(key, "position")) {
      file_.root_position = vector("the root's position");
    } else if (same_word(key, "orientation")) {
      root().axis->angles = vector("the root's orientation");
    }
  }

  std::string axis_order() {
    skip_blanks(cursor_);
    const size_t place = cursor_.at;
    const std::string_view word = next_word_on_line(cursor_);
    for (const std::string_view order : {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
      if (same_word(word, order)) return std::string(order);
    }
    fail(cursor_, place, in_quotes(word) + " is not an order of axes",
         "write the three letters, e.g. XYZ");
  }

  /// The rest of an order or dof line.
  std::vector<AcclaimFreedom> freedoms() {
    std::vector<AcclaimFreedom> found;
    for (;;) {
      skip_blanks(cursor_);
      const size_t place = cursor_.at;
      const std::string_view word = next_word_on_line(cursor_);
      if (word.empty()) return found;
      const std::optional<AcclaimFreedom> freedom = freedom_named(word);
      if (!freedom || found.size() == 6) {
        fail(cursor_, place, in_quotes(word) + " is not a usable degree of freedom",
             "up to six of tx ty tz rx ry rz can be read");
      }
      found.push_back(*freedom);
    }
  }

  void parse_bones() {
    parse_lines([&](std::string_view word, size_t place) {
      if (!same_word(word, "begin")) {
        fail(cursor_, place, "expected begin, found " + in_quotes(word),
             "each bone is enclosed by begin and end");
      }
      skip_line(cursor_);
      parse_bone(place);
    });
  }

  void parse_bone(size_t place) {
    AsfBone bone;
    bone.place = place;
    for (;;) {
      if (section_ends()) {
        fail(cursor_, place, "this bone has no end", "add a line with end");
      }
      if (!is_comment_or_empty(cursor_)) {
        const size_t at = cursor_.at;
        const std::string_view key = next_word_on_line(cursor_);
        if (same_word(key, "end")) break;
        parse_bone_line(bone, key, at);
      }
      skip_line(cursor_);
    }
    require_complete(bone);
    index_.emplace(bone.name, file_.bones.size());
    file_.bones.push_back(std::move(bone));
    if (!is_reasonable_size(file_.bones.size(), 0))  // the place takes all lines above to find
      require_reasonable_size(place_at(cursor_, place), file_.bones.size(), 0);
  }

  /// Limits, masses and ids do not change the motion and are passed over.
  void parse_bone_line(AsfBone& bone, std::string_view key, size_t place) {
    if (same_word(key, "name")) {
      bone.name = next_word_on_line(cursor_);
    } else if (same_word(key, "direction")) {
      bone.direction = vector("the bone's direction");
    } else if (same_word(key, "length")) {
      bone.length = number("the bone's length");
    } else if (same_word(key, "axis")) {
      AsfAxis line;
      line.angles = vector("the bone's axis");
      line.order = axis_order();
      bone.axis = line;
    } else if (same_word(key, "dof")) {
      bone.freedoms = freedoms();
      for (const AcclaimFreedom& freedom : bone.freedoms) {
        if (freedom.rotation) continue;
        fail(cursor_, place, "this bone moves on its parent", "only rx, ry and rz can be read");
      }
    }
  }

  void require_complete(const AsfBone& bone) {
    const auto refuse = [&](const std::string& wrong, std::string_view remedy) {
      fail(cursor_, bone.place, wrong, remedy);
    };
    if (bone.name.empty()) refuse("this bone has no name", "add a line name …");
    const std::string name = in_quotes(bone.name);
    if (bone.name == root_name || index_.contains(bone.name)) {
      refuse("a second bone named " + name, "give every bone its own name");
    }
    if (!bone.direction || !bone.length || !bone.axis) {
      refuse("bone " + name + " lacks its direction, length or axis", "add the missing line");
    }
    if (*bone.length != 0.0 && !(bone.direction->norm() > 1e-9)) {
      refuse("bone " + name + " has no direction", "give a direction that is not zero");
    }
  }

  void parse_hierarchy() {
    has_hierarchy_ = true;
    parse_lines([&](std::string_view word, size_t place) {
      if (same_word(word, "begin") || same_word(word, "end")) return;
      const int parent = block_named(word, place);
      for (;;) {
        skip_blanks(cursor_);
        const size_t at = cursor_.at;
        const std::string_view child = next_word_on_line(cursor_);
        if (child.empty()) return;
        attach(parent, block_named(child, at), at);
      }
    });
  }

  int block_named(std::string_view name, size_t place) {
    if (name == root_name) return 0;
    const auto found = index_.find(std::string(name));
    if (found == index_.end()) {
      fail(cursor_, place, "there is no bone " + in_quotes(name) + " in :bonedata",
           "correct the name or add the bone");
    }
    return static_cast<int>(found->second);
  }

  void attach(int parent, int child, size_t place) {
    AsfBone& bone = file_.bones[static_cast<size_t>(child)];
    if (child == 0 || bone.parent >= 0) {
      fail(cursor_, place, in_quotes(bone.name) + " has a second parent",
           "list each bone once as a child; root is never a child");
    }
    bone.parent = parent;
    file_.bones[static_cast<size_t>(parent)].children.push_back(child);
  }

  TextCursor& cursor_;
  AsfFile file_;
  std::unordered_map<std::string, size_t> index_;  ///< of the bones but the root, by name
  bool has_hierarchy_ = false;
};

}  // namespace

AsfFile parse_asf_file(TextCursor& cursor) { return AsfReader(cursor).read(); }

}  // namespace mien::motion
