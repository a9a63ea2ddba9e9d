#include "pipeline/regression/comparison/frame_alignment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "render/image/resize.h"

namespace mien::pipeline {

namespace {

constexpr int least_band = 240;
constexpr std::size_t most_table_bytes = std::size_t{256} << 20U;
constexpr double infinite = std::numeric_limits<double>::infinity();

double distance(const Thumbnail& a, const Thumbnail& b) {
  if (a.size() != b.size()) return infinite;
  long sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(int{a[i]} - int{b[i]});
  return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(a.size(), 1));
}

double median(std::vector<double> values, double none) {
  if (values.empty()) return none;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// How different frames beside each other are.
double usual_step(const std::vector<Thumbnail>& frames) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i)
    steps.push_back(distance(frames[i - 1], frames[i]));
  return std::max(median(std::move(steps), 1.0), 1e-3);
}

/// How different a frame is from the one that shows the same, by encoding for instance.
double usual_noise(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now) {
  std::vector<double> least;
  for (std::size_t i = 0; i < before.size(); ++i) {
    double nearest = infinite;
    for (std::size_t j = i == 0 ? 0 : i - 1; j < std::min(now.size(), i + 2); ++j)
      nearest = std::min(nearest, distance(before[i], now[j]));
    if (nearest < infinite) least.push_back(nearest);
  }
  return median(std::move(least), 0.0);
}

enum class Step : std::uint8_t { none, pair, missing, added };

/// Half the width of the table's band about the diagonal.
int band_of(std::size_t before, std::size_t now) {
  const int difference = std::abs(static_cast<int>(before) - static_cast<int>(now));
  return std::max(least_band, difference + 16);
}

/// How many steps the table of two sequences has, of a byte each.
std::size_t table_bytes(std::size_t before, std::size_t now) {
  return (before + 1) * (2 * static_cast<std::size_t>(band_of(before, now)) + 1);
}

/// The table of least costs, in a band about the diagonal.
class Table {
 public:
  Table(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now)
      : before_(before),
        now_(now),
        rows_(static_cast<int>(before.size()) + 1),
        columns_(static_cast<int>(now.size()) + 1),
        band_(band_of(before.size(), now.size())),
        gap_(0.45 * usual_step(before) + 2.0 * usual_noise(before, now)),
        steps_(table_bytes(before.size(), now.size())) {
    fill();
  }

  Step step(int row, int column) const { return steps_[index(row, column)]; }

 private:
  bool holds(int row, int column) const {
    return column >= 0 && column < columns_ && std::abs(column - row) <= band_;
  }
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(2 * band_ + 1) +
           static_cast<std::size_t>(column - row + band_);
  }

  void fill() {
    std::vector<double> above(static_cast<std::size_t>(columns_), infinite), here = above;
    for (int row = 0; row < rows_; ++row) {
      std::ranges::fill(here, infinite);
      for (int column = std::max(0, row - band_); holds(row, column); ++column)
        here[static_cast<std::size_t>(column)] = least(row, column, above, here);
      std::swap(above, here);
    }
  }

  double least(int row, int column, const std::vector<double>& above,
               const std::vector<double>& here) {
    const auto c = static_cast<std::size_t>(column);
    if (row == 0 && column == 0) return 0.0;
    double best = infinite;
    const auto offer = [&](double cost, Step step) {
      if (!(cost < best)) return;
      best = cost;
      steps_[index(row, column)] = step;
    };
    if (row > 0 && column > 0)
      offer(above[c - 1] + distance(before_[static_cast<std::size_t>(row - 1)], now_[c - 1]),
            Step::pair);
    if (row > 0) offer(above[c] + gap_, Step::missing);
    if (column > 0) offer(here[c - 1] + gap_, Step::added);
    return best;
  }

  const std::vector<Thumbnail>& before_;
  const std::vector<Thumbnail>& now_;
  int rows_;
  int columns_;
  int band_;
  double gap_;
  std::vector<Step> steps_;
};

/// Frames in a row, from the first up to the one that follows them.
struct Stretch {
  int begin = 0;
  int end = 0;
};

/// Whether inserted frames come from the film itself: copies of an adjacent frame, or of one that
/// is missing.
bool are_of_the_film(Stretch missing, Stretch added, const std::vector<Thumbnail>& before,
                     const std::vector<Thumbnail>& now, double step) {
  for (int frame = added.begin; frame < added.end; ++frame) {
    const Thumbnail& picture = now[static_cast<std::size_t>(frame)];
    for (const int beside : {frame - 1, frame + 1})
      if (beside >= 0 && beside < static_cast<int>(now.size()) &&
          distance(now[static_cast<std::size_t>(beside)], picture) < 0.25 * step)
        return true;
    for (int other = missing.begin; other < missing.end; ++other)
      if (distance(before[static_cast<std::size_t>(other)], picture) < 0.5 * step) return true;
  }
  return false;
}

/// As many frames that are new as are missing, between the same pairs, were changed in their
/// places.
void pair_changed(FrameAlignment& alignment, const std::vector<Thumbnail>& before,
                  const std::vector<Thumbnail>& now, double step) {
  std::vector<FrameAlignment::Pair> pairs;
  int row = 0, column = 0;
  alignment.pairs.push_back({static_cast<int>(before.size()), static_cast<int>(now.size())});
  for (const FrameAlignment::Pair& pair : alignment.pairs) {
    const Stretch missing = {row, pair.before}, added = {column, pair.now};
    const int count = pair.before - row;
    if (count == pair.now - column && !are_of_the_film(missing, added, before, now, step)) {
      for (int i = 0; i < count; ++i) pairs.push_back({row + i, column + i});
      std::erase_if(alignment.missing,
                    [&](int frame) { return frame >= row && frame < pair.before; });
      std::erase_if(alignment.added,
                    [&](int frame) { return frame >= column && frame < pair.now; });
    }
    pairs.push_back(pair);
    row = pair.before + 1;
    column = pair.now + 1;
  }
  pairs.pop_back();
  alignment.pairs = std::move(pairs);
}

/// " (f37.png)"; empty without names.
std::string file_name_text(int frame, const std::vector<std::string>& names) {
  const auto i = static_cast<std::size_t>(frame);
  return i < names.size() ? " (" + names[i] + ")" : "";
}

/// "frame 36 (f37.png)"; without names "frame 36".
std::string frame_text(int frame, const std::vector<std::string>& names) {
  return fmt::format("frame {}{}", frame, file_name_text(frame, names));
}

/// "frame 37 is missing", "frames 3 to 32 are missing": a line for frames in a row.
void note_rows(std::vector<std::string>& remarks, const std::vector<int>& frames, const char* what,
               const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t end = i + 1;
    while (end < frames.size() && frames[end] == frames[end - 1] + 1) ++end;
    const int first = frames[i], last = frames[end - 1];
    remarks.push_back(first == last ? fmt::format("{} is {}", frame_text(first, names), what)
                                    : fmt::format("frames {}{} to {}{} are {}", first,
                                                  file_name_text(first, names), last,
                                                  file_name_text(last, names), what));
    i = end;
  }
}

/// "frames 4 and 5 are swapped" where a frame that is missing was put in beside its place.
void tell(FrameAlignment& alignment, const std::vector<Thumbnail>& before,
          const std::vector<Thumbnail>& now, const FrameNames& names, double step) {
  std::vector<int> added = alignment.added, missing, fresh;
  for (const int frame : alignment.missing) {
    const auto same = std::ranges::find_if(added, [&](int other) {
      return std::abs(other - frame) <= 2 &&
             distance(before[static_cast<std::size_t>(frame)],
                      now[static_cast<std::size_t>(other)]) < 0.5 * step;
    });
    if (same == added.end()) {
      missing.push_back(frame);
    } else {
      const int first = std::min(frame, *same), second = std::max(frame, *same);
      alignment.remarks.push_back(fmt::format("frames {}{} and {}{} are swapped", first,
                                              file_name_text(first, names.before), second,
                                              file_name_text(second, names.before)));
      added.erase(same);
    }
  }
  note_rows(alignment.remarks, missing, "missing", names.before);
  for (const int frame : added) {
    const auto i = static_cast<std::size_t>(frame);
    const auto is_as = [&](std::size_t other) {
      return other < now.size() && distance(now[other], now[i]) < 0.25 * step;
    };
    if (i > 0 && is_as(i - 1))
      alignment.remarks.push_back(frame_text(frame, names.now) + " repeats the previous one");
    else if (is_as(i + 1))
      alignment.remarks.push_back(frame_text(frame + 1, names.now) + " repeats the previous one");
    else
      fresh.push_back(frame);
  }
  note_rows(alignment.remarks, fresh, "new", names.now);
}

/// Frames of the same number, of sequences that are too long or too different in length.
FrameAlignment paired_by_number(int before, int now) {
  FrameAlignment alignment;
  const int both = std::min(before, now);
  for (int frame = 0; frame < both; ++frame) alignment.pairs.push_back({frame, frame});
  for (int frame = both; frame < before; ++frame) alignment.missing.push_back(frame);
  for (int frame = both; frame < now; ++frame) alignment.added.push_back(frame);
  if (before != now)
    alignment.remarks = {fmt::format(
        "{} frames instead of {}; too many to align, so frames of the same number are compared",
        now, before)};
  return alignment;
}

}  // namespace

Thumbnail thumbnail_of(const render::Image8& picture) {
  return render::resized(picture, std::min(thumbnail_width, picture.width),
                         std::min(thumbnail_height, picture.height))
      .channels;
}

FrameAlignment align(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now,
                     const FrameNames& names) {
  if (table_bytes(before.size(), now.size()) > most_table_bytes)
    return paired_by_number(static_cast<int>(before.size()), static_cast<int>(now.size()));
  const Table table(before, now);
  FrameAlignment alignment;
  int row = static_cast<int>(before.size()), column = static_cast<int>(now.size());
  while (row > 0 || column > 0) {
    switch (table.step(row, column)) {
      case Step::pair:
        alignment.pairs.push_back({--row, --column});
        break;
      case Step::missing:
        alignment.missing.push_back(--row);
        break;
      case Step::added:
        alignment.added.push_back(--column);
        break;
      case Step::none:  // pictures of other sizes
        row = column = 0;
        break;
    }
  }
  std::ranges::reverse(alignment.pairs);
  std::ranges::reverse(alignment.missing);
  std::ranges::reverse(alignment.added);
  const double step = usual_step(before);
  pair_changed(alignment, before, now, step);
  tell(alignment, before, now, names, step);
  return alignment;
}

}  // namespace mien::pipeline
