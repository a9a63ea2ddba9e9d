#include <optional>
#include <string>
#include <vector>

#include "pipeline/production/report/tables.h"
#include "pipeline/production/synthesis/fitted_recordings.h"

namespace mien::pipeline {

namespace {

/// A point of a recording.
struct FitRow {
  std::string file;
  std::string subject;
  std::string marker_set;
  double frames_per_second;
  motion::FittedPoint point;

  bool is_used() const { return point.use == motion::PointUse::used; }

  /// Number of gaps, and their frames.
  std::pair<int, int> gaps(bool filled) const {
    std::pair<int, int> result;
    for (const motion::PointGap& gap : point.gaps) {
      if (gap.filled != filled) continue;
      ++result.first;
      result.second += gap.past - gap.first;
    }
    return result;
  }
};

std::string use_of(const FitRow& row) {
  switch (row.point.use) {
    case motion::PointUse::used:
      return "used";
    case motion::PointUse::missing:
      return "missing";
    case motion::PointUse::unknown:
      break;
  }
  return "unknown";
}

constexpr auto fits_columns = table_of<FitRow>(
    "metrics/fits.csv", "point of a recording to which the body was fitted",
    {{"recording", "", "file", [](auto& r) { return r.file; }},
     {"subject", "", "person of the file, as stated in the manifest",
      [](auto& r) { return r.subject; }},
     {"marker_set", "", "recognised set of markers", [](auto& r) { return r.marker_set; }},
     {"point", "", "name of the point", [](auto& r) { return r.point.name; }},
     {"place", "", "place on the body; empty if the name is not one of the set",
      [](auto& r) { return r.point.role; }},
     {"use", "", "used, missing (in all frames) or unknown (not one of the set)",
      [](auto& r) { return use_of(r); }},
     {"rms_mm", "mm",
      "root mean square distance from the body in the frames in which the point was recorded; "
      "empty unless used",
      [](auto& r) { return r.is_used() ? std::optional(r.point.residual_mm) : std::nullopt; }},
     {"filled_gaps", "", "number of gaps that were interpolated for the fit",
      [](auto& r) { return r.gaps(true).first; }},
     {"filled_s", "s", "their total duration",
      [](auto& r) { return r.gaps(true).second / r.frames_per_second; }},
     {"missing_gaps", "",
      "number of gaps that were not filled, because of their length or because they are at the "
      "start or end",
      [](auto& r) { return r.gaps(false).first; }},
     {"missing_s", "s", "their total duration",
      [](auto& r) { return r.gaps(false).second / r.frames_per_second; }}});

std::vector<FitRow> fitted_points(const Manifest& manifest, Motions& motions) {
  std::vector<FitRow> rows;
  for (const FittedRecording& recording : fitted_recordings(manifest, motions)) {
    for (const motion::FittedPoint& point : recording.fit.points)
      rows.push_back({recording.file.filename().string(), recording.how.subject.value_or(""),
                      recording.fit.marker_set, recording.fit.frames_per_second, point});
  }
  return rows;
}

}  // namespace

const StudyTable fits_table = study_table<fits_columns, fitted_points>;

}  // namespace mien::pipeline
