#include "motion/formats/mvnx/mvnx_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "motion/formats/mvnx/xml_events.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

/// The elements that are read; all others, and what is in them, are `other`.
enum class MvnxElement {
  outside,
  document,
  subject,
  segments,
  segment,
  points,
  point,
  point_position,
  joints,
  joint,
  parent_connector,
  child_connector,
  frames,
  frame,
  orientation,
  position,
  left_hand_segments,
  right_hand_segments,
  left_hand_orientation,
  right_hand_orientation,
  left_hand_position,
  right_hand_position,
  other,
};

struct MvnxChild {
  MvnxElement parent;
  std::string_view name;
  MvnxElement element;
};

constexpr MvnxChild known_children[] = {
    {MvnxElement::outside, "mvnx", MvnxElement::document},
    {MvnxElement::outside, "mvn", MvnxElement::document},
    {MvnxElement::outside, "subject", MvnxElement::subject},
    {MvnxElement::outside, "frames", MvnxElement::frames},
    {MvnxElement::document, "subject", MvnxElement::subject},
    {MvnxElement::document, "frames", MvnxElement::frames},
    {MvnxElement::subject, "segments", MvnxElement::segments},
    {MvnxElement::segments, "segment", MvnxElement::segment},
    {MvnxElement::segment, "points", MvnxElement::points},
    {MvnxElement::points, "point", MvnxElement::point},
    {MvnxElement::point, "pos_b", MvnxElement::point_position},
    {MvnxElement::subject, "joints", MvnxElement::joints},
    {MvnxElement::joints, "joint", MvnxElement::joint},
    {MvnxElement::joint, "connector1", MvnxElement::parent_connector},
    {MvnxElement::joint, "connector2", MvnxElement::child_connector},
    {MvnxElement::subject, "frames", MvnxElement::frames},
    {MvnxElement::frames, "frame", MvnxElement::frame},
    {MvnxElement::frame, "orientation", MvnxElement::orientation},
    {MvnxElement::frame, "position", MvnxElement::position},
    {MvnxElement::subject, "fingerTrackingSegmentsLeft", MvnxElement::left_hand_segments},
    {MvnxElement::subject, "fingerTrackingSegmentsRight", MvnxElement::right_hand_segments},
    {MvnxElement::left_hand_segments, "segment", MvnxElement::segment},
    {MvnxElement::right_hand_segments, "segment", MvnxElement::segment},
    {MvnxElement::frame, "orientationFingersLeft", MvnxElement::left_hand_orientation},
    {MvnxElement::frame, "orientationFingersRight", MvnxElement::right_hand_orientation},
    {MvnxElement::frame, "positionFingersLeft", MvnxElement::left_hand_position},
    {MvnxElement::frame, "positionFingersRight", MvnxElement::right_hand_position},
};

MvnxElement child_of(MvnxElement parent, std::string_view name) {
  const auto found = std::ranges::find_if(known_children, [&](const MvnxChild& child) {
    return child.parent == parent && child.name == name;
  });
  return found == std::end(known_children) ? MvnxElement::other : found->element;
}

/// Whether an element holds numbers of a hand in a frame.
bool is_of_hand(MvnxElement element) {
  return element >= MvnxElement::left_hand_orientation &&
         element <= MvnxElement::right_hand_position;
}

bool has_text(MvnxElement element) {
  return is_of_hand(element) || element == MvnxElement::orientation ||
         element == MvnxElement::position || element == MvnxElement::point_position ||
         element == MvnxElement::parent_connector || element == MvnxElement::child_connector;
}

class MvnxReader : public XmlEvents {
 public:
  explicit MvnxReader(const TextCursor& cursor) : cursor_(cursor) {}

  void start(std::string_view name, const XmlAttributes& attributes, size_t place) override {
    constexpr size_t deepest = 64;
    if (open_.size() >= deepest)
      fail(cursor_, place, "tags nested more than 64 deep", "this is no file of MVN");
    const MvnxElement parent = open_.empty() ? MvnxElement::outside : open_.back();
    const MvnxElement element = child_of(parent, name);
    if (parent == MvnxElement::outside && element == MvnxElement::other)
      fail(cursor_, place, "is XML, but not MVNX: it begins with <" + excerpt(name) + ">",
           "export the motion as MVNX from MVN");
    open_.push_back(element);
    if (has_text(element)) begin_text(place);
    if (element == MvnxElement::subject) begin_subject(attributes, place);
    if (element == MvnxElement::frames && parent != MvnxElement::subject) begin_subject({}, place);
    if (element == MvnxElement::segment) {
      segments_of(parent).push_back({attributes.of("label"), {}});
      segment_list_ = parent;
    }
    if (element == MvnxElement::joint) subject().joints.emplace_back();
    if (element == MvnxElement::frame) begin_frame(attributes, place);
  }

  void text(std::string_view characters) override {
    if (!open_.empty() && has_text(open_.back())) text_ += characters;
  }

  void end() override {
    const MvnxElement element = open_.back();
    open_.pop_back();
    if (element == MvnxElement::point_position) add_point();
    if (element == MvnxElement::parent_connector)
      subject().joints.back().parent = connected_segment();
    if (element == MvnxElement::child_connector)
      subject().joints.back().child = connected_segment();
    if (element == MvnxElement::frame && is_normal_) end_frame();
    if (!is_normal_) return;
    if (is_of_hand(element)) add_numbers_of_hand(element);
    if (element == MvnxElement::orientation)
      add_numbers(subject().orientations, orientations_before_, orientation_count_, "orientation");
    if (element == MvnxElement::position)
      add_numbers(subject().positions, positions_before_, position_count_, "position");
  }

  std::vector<MvnxSubject> subjects;

 private:
  MvnxSubject& subject() { return subjects.back(); }

  /// The list of segments that an element holds.
  std::vector<MvnxSegment>& segments_of(MvnxElement list) {
    if (list == MvnxElement::left_hand_segments) return subject().hands[0].segments;
    if (list == MvnxElement::right_hand_segments) return subject().hands[1].segments;
    return subject().segments;
  }

  void add_numbers_of_hand(MvnxElement element) {
    const bool is_left =
        element == MvnxElement::left_hand_orientation || element == MvnxElement::left_hand_position;
    MvnxHand& hand = subject().hands[is_left ? 0 : 1];
    const bool is_position =
        element == MvnxElement::left_hand_position || element == MvnxElement::right_hand_position;
    parse_numbers(is_position ? hand.positions : hand.orientations, "finger tracking");
  }

  void begin_text(size_t place) {
    text_.clear();
    text_place_ = place;
  }

  void begin_subject(const XmlAttributes& attributes, size_t place) {
    if (!is_reasonable_size(subjects.size() + 1, 1))
      fail(cursor_, place, "there are more people than can be read", "keep those that are needed");
    subjects.emplace_back();
    subject().label = attributes.of("label");
    subject().place = place;
    orientation_count_ = position_count_ = 0;
    const std::string rate = attributes.of("frameRate");
    if (!rate.empty()) subject().frame_rate = number(rate, place, "frameRate");
  }

  void begin_frame(const XmlAttributes& attributes, size_t place) {
    const std::string type = attributes.of("type");
    is_normal_ = type.empty() || type == "normal";
    if (!is_normal_) return;
    MvnxSubject& now = subject();
    now.frames.push_back(place);
    const std::string time = attributes.of("time");
    if (!time.empty()) now.times.push_back(number(time, place, "time"));
    orientations_before_ = now.orientations.size();
    positions_before_ = now.positions.size();
  }

  std::string frame_name() const {
    return "frame " + std::to_string(subjects.back().frames.size());
  }

  void end_frame() {
    is_normal_ = false;
    const MvnxSubject& now = subject();
    const size_t place = now.frames.back();
    if (now.orientations.size() == orientations_before_)
      fail(cursor_, place, frame_name() + " has no orientation",
           "export the orientations of the segments too");
    if (now.positions.size() == positions_before_ && position_count_ > 0)
      fail(cursor_, place, frame_name() + " has no position, unlike those before it",
           "export the file again");
    if (now.frames.size() > 1 && positions_before_ == 0 && position_count_ > 0)
      fail(cursor_, now.frames.front(), "frame 1 has no position, unlike a later one",
           "export the file again");
    require_reasonable_size(place_at(cursor_, 0), orientation_count_ / 4, now.frames.size());
  }

  /// Adds the numbers of a frame, as many as the first frame has.
  void add_numbers(std::vector<double>& numbers, size_t before_frame, size_t& count,
                   const std::string& what) {
    if (numbers.size() != before_frame)
      fail(cursor_, text_place_, "a second " + what + " in " + frame_name(),
           "export the file again");
    parse_numbers(numbers, what);
    const size_t added = numbers.size() - before_frame;
    if (count == 0) count = added;
    if (added == 0 || added != count)
      fail(cursor_, text_place_,
           what + " of " + frame_name() + " has " + std::to_string(added) + " numbers" +
               (added == 0 ? "" : ", not " + std::to_string(count) + " as the first"),
           "export the file again");
  }

  void parse_numbers(std::vector<double>& numbers, std::string_view what) {
    const char* at = text_.data();
    const char* const end = at + text_.size();
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    for (;;) {
      while (at != end && is_blank(*at)) ++at;
      if (at == end) return;
      const char* const word_end = std::find_if(at, end, is_blank);
      numbers.push_back(number({at, static_cast<size_t>(word_end - at)}, text_place_, what));
      at = word_end;
    }
  }

  double number(std::string_view word, size_t place, std::string_view what) {
    constexpr double largest = 1e12;
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const std::from_chars_result result = std::from_chars(word.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !(std::abs(value) <= largest))
      fail(cursor_, place, std::string(what) + ": " + in_quotes(word) + " is not a valid number",
           "export the file again");
    return value;
  }

  void add_point() {
    std::vector<double> numbers;
    parse_numbers(numbers, "pos_b");
    if (numbers.size() != 3)
      fail(cursor_, text_place_, "pos_b has " + std::to_string(numbers.size()) + " numbers, not 3",
           "export the file again");
    const Vec3 point(numbers.data());
    std::optional<Vec3>& farthest = segments_of(segment_list_).back().farthest_point;
    if (!farthest || point.norm() > farthest->norm()) farthest = point;
  }

  /// "Pelvis" of "Pelvis/jL5S1".
  std::string connected_segment() const {
    constexpr std::string_view blanks = " \t\r\n";
    std::string_view name = std::string_view(text_).substr(0, text_.find('/'));
    name.remove_prefix(std::min(name.find_first_not_of(blanks), name.size()));
    return std::string(name.substr(0, name.find_last_not_of(blanks) + 1));
  }

  const TextCursor& cursor_;
  std::vector<MvnxElement> open_;
  std::string text_;  ///< of the element that is open
  size_t text_place_ = 0;
  MvnxElement segment_list_ = MvnxElement::segments;  ///< of the segment that is open
  bool is_normal_ = false;                            ///< inside a frame of type "normal"
  size_t orientation_count_ = 0;                      ///< numbers a frame; 0 before the first
  size_t position_count_ = 0;
  size_t orientations_before_ = 0;  ///< numbers before this frame
  size_t positions_before_ = 0;
};

}  // namespace

std::vector<MvnxSubject> parse_mvnx_subjects(std::string_view text, const std::string& file_name) {
  const TextCursor cursor{text, file_name};
  MvnxReader reader(cursor);
  parse_xml(cursor, reader);
  if (reader.subjects.empty())
    fail(cursor, 0, "there is no subject", "export the motion as MVNX from MVN");
  for (MvnxSubject& subject : reader.subjects) {
    if (subject.times.size() != subject.frames.size()) subject.times.clear();
  }
  return std::move(reader.subjects);
}

}  // namespace mien::motion
