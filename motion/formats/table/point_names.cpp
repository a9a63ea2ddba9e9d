#include "motion/formats/table/point_names.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "motion/formats/reading/chosen_subject.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// Keeps some of the points, by index.
void keep_points(PointRecording& recording, const std::vector<std::size_t>& kept) {
  const auto frames = static_cast<std::size_t>(recording.frame_count());
  const std::size_t before = recording.points.size();
  std::vector<Vec3> positions(frames * kept.size());
  std::vector<bool> seen(frames * kept.size());
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t k = 0; k < kept.size(); ++k) {
      positions[f * kept.size() + k] = recording.positions[f * before + kept[k]];
      seen[f * kept.size() + k] = recording.seen[f * before + kept[k]];
    }
  }
  std::vector<std::string> names;
  for (const std::size_t k : kept) names.push_back(std::move(recording.points[k]));
  recording.points = std::move(names);
  recording.positions = std::move(positions);
  recording.seen = std::move(seen);
}

void refuse_subject(const ReadOptions& options, const Place& place) {
  if (!options.subject) return;
  throw Error(place, "names no people, so " + in_quotes(*options.subject) + " cannot be chosen",
              "remove subject:");
}

}  // namespace

std::vector<std::string> distinct_names(std::vector<std::string> names) {
  std::unordered_set<std::string> taken(names.begin(), names.end());
  std::unordered_map<std::string, int> used;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string& name = names[i];
    const std::string given = name.empty() ? "point" : name;
    int& number = used[given];
    if (name.empty() && number == 0) number = static_cast<int>(i);
    ++number;
    if (!name.empty() && number == 1) continue;
    while (true) {
      name = given + " " + std::to_string(number);
      if (taken.insert(name).second) break;
      ++number;
    }
  }
  return names;
}

void split_subjects(PointRecording& recording, const ReadOptions& options, const Place& place) {
  std::vector<std::string> subjects;
  std::unordered_map<std::string, std::size_t> index_of;
  std::vector<std::size_t> subject_of;
  for (const std::string& point : recording.points) {
    const std::size_t colon = point.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == point.size())
      return refuse_subject(options, place);
    const std::string subject = point.substr(0, colon);
    const auto [found, is_new] = index_of.emplace(subject, subjects.size());
    if (is_new) subjects.push_back(subject);
    subject_of.push_back(found->second);
  }
  if (subjects.size() > 1 && !options.subject) {
    recording.notes.push_back("The points are those of " + std::to_string(subjects.size()) +
                              " people or objects (" + listed(subjects) +
                              "); all are read. Choose one with subject:.");
    recording.subjects = std::move(subjects);
    return;
  }
  const std::size_t chosen = chosen_subject(place, subjects, options.subject);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < subject_of.size(); ++i)
    if (subject_of[i] == chosen) kept.push_back(i);
  if (kept.size() < subject_of.size()) keep_points(recording, kept);
  for (std::string& point : recording.points) point.erase(0, subjects[chosen].size() + 1);
  recording.points = distinct_names(std::move(recording.points));
  recording.subject = subjects[chosen];
  recording.subjects = std::move(subjects);
}

}  // namespace mien::motion
