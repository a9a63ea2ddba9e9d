#include "motion/formats/table/column_name.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_joiner(char c) { return std::string_view("_.: -/|").find(c) != std::string_view::npos; }

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view w) { return same_word(w, word); });
}

/// 0 to 3 for x, y, z, w; −1 for other letters.
int axis_letter(char c) {
  const std::size_t at = std::string_view("xyzw").find(lower(c));
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

std::string_view without_joiners_at_ends(std::string_view text) {
  while (!text.empty() && is_joiner(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_joiner(text.back())) text.remove_suffix(1);
  return text;
}

/// The words of a name, in lower case: letters and digits between anything else.
std::vector<std::string> words_of(std::string_view name) {
  constexpr std::size_t most_words = 16;
  std::vector<std::string> words(1);
  for (const char c : name) {
    const bool is_in_word = is_upper(c) || is_lower(c) || is_digit(c) || (c & 0x80) != 0;
    if (is_in_word) {
      words.back() += lower(c);
    } else if (!words.back().empty()) {
      if (words.size() == most_words) break;
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string_view last_word(std::string_view base) {
  const auto joiner = std::find_if(base.rbegin(), base.rend(), is_joiner);
  return base.substr(static_cast<std::size_t>(base.rend() - joiner));
}

/// Takes "(mm)" or "[mm]" off the end of a name, and returns what is between.
std::optional<std::string_view> take_bracketed(std::string_view& name) {
  if (name.empty() || (name.back() != ')' && name.back() != ']')) return std::nullopt;
  const std::size_t open = name.rfind(name.back() == ')' ? '(' : '[');
  if (open == std::string_view::npos) return std::nullopt;
  const std::string_view inside = name.substr(open + 1, name.size() - open - 2);
  name = without_joiners_at_ends(name.substr(0, open));
  return inside;
}

/// A name that ends or begins with the letter of an axis.
std::optional<AxisName> with_axis(std::string_view name) {
  if (name.empty()) return std::nullopt;
  if (name.size() == 1 && axis_letter(name[0]) >= 0) return AxisName{{}, axis_letter(name[0])};
  const int last = axis_letter(name.back());
  const char before = name.size() > 1 ? name[name.size() - 2] : '\0';
  if (last >= 0 && is_joiner(before))
    return AxisName{without_joiners_at_ends(name.substr(0, name.size() - 1)), last};
  const int first = axis_letter(name.front());
  if (first >= 0 && name.size() > 2 && is_joiner(name[1]))
    return AxisName{without_joiners_at_ends(name.substr(1)), first};
  if (last >= 0 && is_upper(name.back()) && (is_lower(before) || is_digit(before)))
    return AxisName{name.substr(0, name.size() - 1), last};
  return std::nullopt;
}

std::optional<LengthUnit> metric_unit(std::string_view word) {
  constexpr std::array<std::string_view, 3> metric = {"m", "cm", "mm"};
  const std::optional<LengthUnit> unit = length_unit(word);
  return unit && is_one_of(unit->name, metric) ? unit : std::nullopt;
}

struct TimeUnit {
  std::string_view word;
  double seconds;
};

constexpr TimeUnit time_units[] = {
    {"s", 1.0},       {"sec", 1.0},           {"secs", 1.0},  {"second", 1.0},
    {"seconds", 1.0}, {"ms", 1e-3},           {"msec", 1e-3}, {"milliseconds", 1e-3},
    {"us", 1e-6},     {"microseconds", 1e-6}, {"ns", 1e-9},   {"nanoseconds", 1e-9}};

/// A name of words of time and at most one unit of time.
std::optional<NamedColumn> as_time(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 6> of_time = {"time",  "timestamp", "timestamps",
                                                       "stamp", "elapsed",   "t"};
  NamedColumn column{ColumnUse::time};
  for (const std::string& word : words) {
    const auto* const unit =
        std::ranges::find_if(time_units, [&](const TimeUnit& u) { return u.word == word; });
    if (unit != std::end(time_units) && !column.has_unit) {
      column.seconds_per_unit = unit->seconds;
      column.has_unit = true;
    } else if (!is_one_of(word, of_time)) {
      return std::nullopt;
    }
  }
  const bool is_letter_alone = words.size() == 1 && words[0] == "s";
  return words.empty() || is_letter_alone ? std::nullopt : std::optional(column);
}

bool is_frame(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 8> beside = {"no", "nr",    "num", "number",
                                                      "id", "index", "idx", "frame"};
  constexpr std::array<std::string_view, 5> alone = {"frame", "frames", "framenumber", "frameid",
                                                     "frameindex"};
  if (words.size() == 1) return is_one_of(words[0], alone);
  return !words.empty() && words[0] == "frame" &&
         std::ranges::all_of(words, [&](const std::string& w) { return is_one_of(w, beside); });
}

}  // namespace

std::optional<AxisName> axis_name(std::string_view name) {
  name = without_joiners_at_ends(name);
  std::optional<LengthUnit> unit;
  if (const auto bracketed = take_bracketed(name)) {
    unit = length_unit(*bracketed);
    if (!unit) return std::nullopt;
  }
  std::optional<AxisName> found = with_axis(name);
  const std::string_view end = last_word(name);
  if (!unit && end.size() < name.size()) {
    const std::string_view before =
        without_joiners_at_ends(name.substr(0, name.size() - end.size()));
    const std::optional<LengthUnit> at_end = metric_unit(end);
    if (const auto axis = at_end ? with_axis(before) : std::nullopt) {
      found = axis;
      unit = at_end;
    }
  }
  if (!found) return std::nullopt;
  found->unit = unit;
  constexpr std::array<std::string_view, 3> positions = {"pos", "position", "coordinate"};
  const std::string_view of = last_word(found->base);
  if (is_one_of(of, positions))
    found->base = without_joiners_at_ends(found->base.substr(0, found->base.size() - of.size()));
  return found;
}

bool is_other_quantity(std::string_view base) {
  constexpr std::array<std::string_view, 22> others = {
      "rot",         "rotation",     "euler", "quat",  "quaternion", "q",
      "orientation", "angle",        "ang",   "vel",   "velocity",   "acc",
      "accel",       "acceleration", "gyro",  "mag",   "force",      "moment",
      "torque",      "omega",        "eul",   "normal"};
  return is_one_of(last_word(base), others);
}

NamedColumn named_column(std::string_view name) {
  constexpr std::size_t longest = 64;
  if (name.size() > longest) return {};
  const std::vector<std::string> words = words_of(name);
  if (is_frame(words)) return {ColumnUse::frame};
  if (const auto time = as_time(words)) return *time;
  std::string joined;
  for (const std::string& word : words) joined += word;
  constexpr std::array<std::string_view, 14> points = {
      "point",      "pointname", "keypoint",  "keypointname", "marker",
      "markername", "joint",     "jointname", "landmark",     "landmarkname",
      "bodypart",   "name",      "label",     "trackedpoint"};
  constexpr std::array<std::string_view, 8> subjects = {"subject",    "subjectid",   "person",
                                                        "personid",   "participant", "actor",
                                                        "individual", "skeleton"};
  if (is_one_of(joined, points)) return {ColumnUse::point};
  if (is_one_of(joined, subjects)) return {ColumnUse::subject};
  if (joined == "model") return {ColumnUse::model};
  if (joined == "trajectory") return {ColumnUse::trajectory};
  return {};
}

}  // namespace mien::motion
