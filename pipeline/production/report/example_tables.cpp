#include <algorithm>
#include <optional>
#include <vector>

#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/report/tables.h"

namespace mien::pipeline {

namespace {

struct ExampleRow {
  std::string name;
  const motion::Example& example;
  const motion::ExampleOrigin* origin;  ///< null of a built-in example

  template <class Value>
  std::optional<Value> of_file(Value motion::ExampleOrigin::*value) const {
    return origin != nullptr ? std::optional(origin->*value) : std::nullopt;
  }
  std::optional<int> frame(int motion::FrameRange::*end) const {
    return origin != nullptr ? std::optional(origin->frames.*end) : std::nullopt;
  }
  std::optional<double> seconds(int motion::FrameRange::*end) const {
    return origin != nullptr ? std::optional(origin->frames.*end / origin->frames_per_second)
                             : std::nullopt;
  }
  std::string keytimes() const {
    std::string text;
    for (const double value : example.keytimes) text += (text.empty() ? "" : " ") + shortest(value);
    return text;
  }
};

struct ExpectedExample {
  ExpectationCheck check;
  std::size_t place;  ///< in the order, from 0
  std::string ratings;

  std::optional<bool> is_above_previous() const {
    if (place == 0) return std::nullopt;
    return std::ranges::count(check.violated, place - 1) == 0;
  }
  /// The step from the previous example, by the people who rated both.
  template <class Value>
  std::optional<Value> of_step(Value ExpectedStep::*value) const {
    if (place == 0 || check.steps[place - 1].people == 0) return std::nullopt;
    return check.steps[place - 1].*value;
  }
};

constexpr auto examples_columns = table_of<ExampleRow>(
    "metrics/examples.csv", "example",
    {{"example", "", "example label, as in weights and ratings", [](auto& r) { return r.name; }},
     {"file", "", "motion file; empty for a built-in example",
      [](auto& r) { return r.origin ? r.origin->file.filename().string() : ""; }},
     {"take_fps", "1/s", "frames per second of the file",
      [](auto& r) { return r.of_file(&motion::ExampleOrigin::frames_per_second); }},
     {"take_frames", "", "frames in the file",
      [](auto& r) { return r.of_file(&motion::ExampleOrigin::file_frames); }},
     {"first_frame", "", "first frame of the part used, counted from 0",
      [](auto& r) { return r.frame(&motion::FrameRange::first); }},
     {"last_frame", "", "last frame of that part",
      [](auto& r) { return r.frame(&motion::FrameRange::last); }},
     {"first_s", "s", "time of first_frame in the file",
      [](auto& r) { return r.seconds(&motion::FrameRange::first); }},
     {"last_s", "s", "time of last_frame in the file",
      [](auto& r) { return r.seconds(&motion::FrameRange::last); }},
     {"loops", "0/1", "1: one gait cycle, closed into a loop",
      [](auto& r) { return r.example.clip.loops; }},
     {"mirrored", "0/1",
      "1: only one step of the file is used; the other step of the cycle is its mirror image",
      [](auto& r) { return r.origin && r.origin->is_mirrored; }},
     {"duration_s", "s", "duration of the example",
      [](auto& r) { return r.example.clip.duration_seconds(); }},
     {"keytimes_s", "s",
      "keytimes: corresponding moments from the example's start, separated by spaces; of a gait "
      "cycle: left heel strike, right toe off, left mid-stance, right heel strike, left toe off, "
      "right mid-stance, left heel strike",
      [](auto& r) { return r.keytimes(); }}});

constexpr auto expectations_columns = table_of<ExpectedExample>(
    "metrics/expectations.csv", "example of an expected order",
    {{"parameter", "", "scale or group for which an order is expected",
      [](auto& r) { return r.check.parameter; }},
     {"ratings", "", "source of the ratings: given (by people) or simulated",
      [](auto& r) { return r.ratings; }},
     {"place", "", "rank in the expected order, 1 nearest to the low end",
      [](auto& r) { return r.place + 1; }},
     {"example", "", "label of the example expected at that rank",
      [](auto& r) { return r.check.order[r.place].example; }},
     {"value", "0–1", "mean rating: 0 low end of the scale, 1 high end",
      [](auto& r) { return r.check.order[r.place].value; }},
     {"above_previous", "0/1", "1: rated above the example expected below it; empty for the first",
      [](auto& r) { return r.is_above_previous(); }},
     {"people", "",
      "number of participants who rated this example and the one before; empty for the first "
      "example and for "
      "given means",
      [](auto& r) { return r.of_step(&ExpectedStep::people); }},
     {"difference", "0–1",
      "mean over those participants of this example's value minus that of the one before",
      [](auto& r) { return r.of_step(&ExpectedStep::difference); }},
     {"difference_low", "0–1", "lower end of its 95 % interval (paired t)",
      [](auto& r) { return r.of_step(&ExpectedStep::low); }},
     {"difference_high", "0–1", "upper end of that interval",
      [](auto& r) { return r.of_step(&ExpectedStep::high); }},
     {"holds", "0/1", "1: the whole order is as expected", [](auto& r) { return r.check.holds(); }},
     {"is_certain", "0/1",
      "1: the order is as expected, and the interval of every step lies above 0",
      [](auto& r) { return r.check.is_certain(); }}});

std::vector<ExampleRow> example_rows(const Manifest& manifest, Motions& motions) {
  if (!uses_examples(manifest)) return {};
  const Repertoire& repertoire = motions.repertoire();
  std::vector<ExampleRow> rows;
  for (std::size_t i = 0; i < repertoire.names.size(); ++i)
    rows.push_back({repertoire.names[i].name, repertoire.examples.examples[i],
                    i < repertoire.origins.size() ? &repertoire.origins[i] : nullptr});
  return rows;
}

std::vector<ExpectedExample> expected_examples(const Manifest& manifest, Motions& motions) {
  if (manifest.ratings.expected.empty() || !uses_examples(manifest)) return {};
  std::vector<ExpectedExample> rows;
  for (const ExpectationCheck& check : expectation_checks(manifest, motions.repertoire()))
    for (std::size_t i = 0; i < check.order.size(); ++i)
      rows.push_back({check, i, origin_text(motions.repertoire().simulated_ratings)});
  return rows;
}

}  // namespace

const StudyTable examples_table = study_table<examples_columns, example_rows>;
const StudyTable expectations_table = study_table<expectations_columns, expected_examples>;

const StudyTable impressions_table = {
    impressions_form, [](const Manifest& manifest, Motions& motions) {
      const bool are_rated = blends_examples(manifest) && motions.repertoire().impressions;
      return are_rated
                 ? impressions_csv(*motions.repertoire().impressions, motions.repertoire().scales)
                 : impressions_csv({}, {});
    }};

}  // namespace mien::pipeline
