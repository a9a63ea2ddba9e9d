#include "motion/formats/reading/points_of_subject.h"

#include <unordered_map>
#include <utility>

#include "motion/formats/reading/chosen_subject.h"
#include "motion/formats/reading/option_names.h"
#include "motion/points/kept_points.h"
#include "motion/points/point_names.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

void refuse_subject(const ReadOptions& options, const Place& place) {
  if (!options.subject) return;
  throw Error(place, "names no people, so " + in_quotes(*options.subject) + " cannot be chosen",
              "omit the subject");
}

}  // namespace

void keep_points_of_subject(PointRecording& recording, const ReadOptions& options,
                            const Place& place) {
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
                              "); all are read. Choose one with " + subject_option + ".");
    recording.subjects = std::move(subjects);
    return;
  }
  const std::size_t chosen = chosen_subject(place, subjects, options.subject);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < subject_of.size(); ++i)
    if (subject_of[i] == chosen) kept.push_back(i);
  if (kept.size() < subject_of.size()) keep_points(recording, kept);
  for (std::string& point : recording.points) point.erase(0, subjects[chosen].size() + 1);
  recording.points = distinct_point_names(std::move(recording.points), recording.notes);
  recording.subject = subjects[chosen];
  recording.subjects = std::move(subjects);
}

}  // namespace mien::motion
