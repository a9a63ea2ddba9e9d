#include <algorithm>
#include <cmath>

#include "motion/formats/c3d/c3d_points.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_events = 65'536;
constexpr std::size_t seconds_per_minute = 60;

// Events of the header: bytes at which they begin, and how many there may be.
constexpr std::size_t key_byte = 298;
constexpr std::size_t count_byte = 300;
constexpr std::size_t times_byte = 304;
constexpr std::size_t labels_byte = 396;
constexpr std::size_t most_header_events = 18;
constexpr std::uint16_t key = 12345;

std::string text_at(const std::vector<std::string>& texts, std::size_t index) {
  return index < texts.size() ? texts[index] : std::string();
}

std::vector<PointEvent> events_of_group(const C3dFile& file, const std::string& subject) {
  const std::vector<std::string> labels = c3d_all_texts(file, "EVENT:LABELS");
  const std::vector<std::string> contexts = c3d_all_texts(file, "EVENT:CONTEXTS");
  const std::vector<std::string> subjects = c3d_all_texts(file, "EVENT:SUBJECTS");
  const std::size_t used = c3d_count(file, "EVENT:USED").value_or(most_events);
  std::vector<PointEvent> events;
  for (std::size_t i = 0; i < std::min(used, most_events); ++i) {
    const std::optional<double> minutes = c3d_number(file, "EVENT:TIMES", 2 * i);
    const std::optional<double> seconds = c3d_number(file, "EVENT:TIMES", 2 * i + 1);
    if (!minutes || !seconds) break;
    const std::string whose = text_at(subjects, i);
    if (!subject.empty() && !whose.empty() && whose != subject) continue;
    events.push_back(
        {text_at(labels, i), text_at(contexts, i), *minutes * seconds_per_minute + *seconds});
  }
  return events;
}

std::vector<PointEvent> events_of_header(const C3dFile& file) {
  const char* bytes = file.bytes.data();
  if (c3d_word(bytes + key_byte, file.processor) != key) return {};
  const std::size_t used =
      std::min<std::size_t>(c3d_word(bytes + count_byte, file.processor), most_header_events);
  std::vector<PointEvent> events;
  for (std::size_t i = 0; i < used; ++i) {
    std::string_view label = file.bytes.substr(labels_byte + 4 * i, 4);
    label = label.substr(0, label.find('\0'));
    label = label.substr(0, label.find_last_not_of(' ') + 1);
    events.push_back(
        {std::string(label), "", c3d_real(bytes + times_byte + 4 * i, file.processor)});
  }
  return events;
}

}  // namespace

std::vector<PointEvent> c3d_events(const C3dFile& file, const C3dLayout& layout,
                                   const std::string& subject) {
  std::vector<PointEvent> events = events_of_group(file, subject);
  if (events.empty()) events = events_of_header(file);
  std::erase_if(events, [](const PointEvent& event) { return !std::isfinite(event.seconds); });
  // Times count from the trial's frame 1. Some writers of parts of trials count from the first
  // frame of the file instead: then more of the events lie within it as they stand.
  const double start = (layout.first_frame - 1.0) / layout.frames_per_second;
  const double length = static_cast<double>(layout.frames) / layout.frames_per_second;
  const auto within = [&](double from) {
    return std::ranges::count_if(events, [&](const PointEvent& event) {
      return event.seconds >= from && event.seconds <= from + length;
    });
  };
  if (within(start) >= within(0.0)) {
    for (PointEvent& event : events) event.seconds -= start;
  }
  std::ranges::stable_sort(events, {}, &PointEvent::seconds);
  return events;
}

}  // namespace mien::motion
