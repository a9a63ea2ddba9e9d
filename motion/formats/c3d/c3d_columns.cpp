#include "motion/formats/c3d/c3d_columns.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/reading/option_names.h"
#include "motion/points/point_names.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

constexpr int least_points_of_a_prefix = 3;
constexpr std::size_t most_people = 256;

/// "Ann" of "Ann:LASI"; empty if there is none.
std::string_view prefix_of(std::string_view label) {
  const std::size_t colon = label.find(':');
  return colon == std::string_view::npos || colon + 1 == label.size() ? std::string_view()
                                                                      : label.substr(0, colon);
}

std::string_view without_prefix(std::string_view label) {
  const std::string_view prefix = prefix_of(label);
  return prefix.empty() ? label : label.substr(prefix.size() + 1);
}

/// People of the file, and to which of them each label belongs (−1: to none).
struct People {
  std::vector<std::string> names;
  std::vector<int> of_label;
  int with_labels = 0;  ///< number of people who have labels with a prefix
};

int index_of(const std::vector<std::string>& names, std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (same_word(names[i], name)) return static_cast<int>(i);
  }
  return -1;
}

People people_of(const C3dFile& file, const std::vector<std::string>& labels) {
  People people;
  std::vector<std::string> prefixes = c3d_texts(file, "SUBJECTS:LABEL_PREFIXES");
  for (std::string& prefix : prefixes) {
    if (prefix.ends_with(':')) prefix.pop_back();
  }
  std::map<std::string_view, int> person_of;  // by prefix as written
  const std::vector<std::string> stated = c3d_texts(file, "SUBJECTS:NAMES");
  for (std::size_t i = 0; i < stated.size() && i < most_people; ++i) {
    if (!stated[i].empty() && index_of(people.names, stated[i]) < 0)
      people.names.push_back(stated[i]);
    if (i >= prefixes.size() || prefixes[i].empty() || stated[i].empty()) continue;
    person_of.try_emplace(prefixes[i], index_of(people.names, stated[i]));
  }
  std::map<std::string_view, int> borne;
  for (const std::string& label : labels) ++borne[prefix_of(label)];
  for (const std::string& label : labels) {
    const std::string_view prefix = prefix_of(label);
    if (prefix.empty() || person_of.contains(prefix)) continue;
    int person = index_of(people.names, prefix);
    if (person < 0 && prefix.size() > 1 && borne[prefix] >= least_points_of_a_prefix &&
        people.names.size() < most_people) {
      person = static_cast<int>(people.names.size());
      people.names.emplace_back(prefix);
    }
    person_of.emplace(prefix, person);
  }
  std::set<int> with_labels;
  for (const std::string& label : labels) {
    const auto person = person_of.find(prefix_of(label));
    people.of_label.push_back(person == person_of.end() ? -1 : person->second);
    if (people.of_label.back() >= 0) with_labels.insert(people.of_label.back());
  }
  people.with_labels = static_cast<int>(with_labels.size());
  return people;
}

/// The person of that name, or else of that number from 1.
int chosen_person(const C3dFile& file, const People& people, const std::string& wanted) {
  const int named = index_of(people.names, wanted);
  if (named >= 0) return named;
  const std::optional<int> number = as_number<int>(wanted);
  if (number && *number >= 1 && *number <= static_cast<int>(people.names.size()))
    return *number - 1;
  throw Error({file.name}, "there is no subject " + in_quotes(wanted),
              people.names.empty() ? "omit the subject, the file names none"
                                   : "choose one of: " + listed(people.names));
}

/// Labels that are stored among the points but are listed as something else.
std::set<std::string> listed_results(const C3dFile& file) {
  std::set<std::string> groups = {"ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS", "REACTIONS"};
  for (const std::string& group : c3d_texts(file, "POINT:TYPE_GROUPS")) {
    const bool is_other_list =
        group.ends_with("_UNITS") || group == "LABELS" || group.find("MARKER") != std::string::npos;
    if (!group.empty() && !is_other_list) groups.insert(group);
  }
  std::set<std::string> results;
  for (const std::string& group : groups) {
    const std::vector<std::string> labels = c3d_all_texts(file, "POINT:" + group);
    results.insert(labels.begin(), labels.end());
  }
  results.erase("");
  return results;
}

bool ends_as_a_result(std::string_view label) {
  for (const std::string_view ending : {"Angle", "Force", "Moment", "Power"}) {
    if (label.ends_with(ending) && label.size() > ending.size()) return true;
    if (label.ends_with('s') && label.substr(0, label.size() - 1).ends_with(ending) &&
        label.size() > ending.size() + 1)
      return true;
  }
  return false;
}

void note_people(const People& people, const C3dColumns& chosen, std::vector<std::string>& notes) {
  if (people.with_labels < 2) return;
  if (chosen.subject.empty()) {
    notes.push_back("The file holds the points of " + std::to_string(people.with_labels) +
                    " people (" + listed(people.names) + "); all are read. Choose one with " +
                    subject_option + ".");
  } else {
    notes.push_back("Only the points of " + excerpt(chosen.subject) + " are read, one of " +
                    std::to_string(people.with_labels) + " people in the file.");
  }
}

}  // namespace

C3dColumns c3d_columns(const C3dFile& file, std::size_t points, const ReadOptions& options,
                       std::vector<std::string>& notes) {
  std::vector<std::string> labels = c3d_all_texts(file, "POINT:LABELS");
  labels.resize(points);
  const People people = people_of(file, labels);
  C3dColumns chosen;
  chosen.subjects = people.names;
  int person = people.names.size() == 1 ? 0 : -1;
  if (options.subject) person = chosen_person(file, people, *options.subject);
  if (person >= 0) chosen.subject = people.names[static_cast<std::size_t>(person)];
  const bool only_theirs = options.subject && people.names.size() > 1;
  if (only_theirs && std::ranges::find(people.of_label, person) == people.of_label.end()) {
    throw Error(
        {file.name},
        "the names of the points do not say which are those of " + in_quotes(chosen.subject),
        "omit the subject, so that all points are read");
  }
  const bool strip = only_theirs || people.with_labels == 1;

  const std::set<std::string> results = listed_results(file);
  std::vector<std::string> left_out;
  for (std::size_t i = 0; i < points; ++i) {
    if (only_theirs && people.of_label[i] != person) continue;
    const std::string bare(without_prefix(labels[i]));
    if (results.contains(labels[i]) || results.contains(bare) || ends_as_a_result(labels[i])) {
      left_out.push_back(labels[i]);
      continue;
    }
    chosen.names.push_back(strip && people.of_label[i] >= 0 ? bare : labels[i]);
    chosen.columns.push_back(i);
  }
  if (chosen.names.empty()) {
    throw Error({file.name}, "none of its points is a position: " + listed(left_out),
                "export the markers or joint centres");
  }
  note_people(people, chosen, notes);
  if (!left_out.empty()) {
    notes.push_back("Left out, since they are no positions: " + listed(left_out) + ".");
  }
  chosen.names = distinct_point_names(std::move(chosen.names), notes);
  return chosen;
}

}  // namespace mien::motion
