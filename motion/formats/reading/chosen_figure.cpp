#include "motion/formats/reading/chosen_figure.h"

#include "motion/formats/reading/chosen_subject.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

std::size_t chosen_figure(const Place& place, const std::vector<std::string>& names,
                          std::size_t usual, const std::optional<std::string>& wanted,
                          Recording& recording) {
  const std::vector<std::string> distinct = subject_names(names);
  const std::size_t chosen = wanted ? chosen_subject(place, distinct, wanted) : usual;
  if (distinct.size() < 2) return chosen;
  recording.subjects = distinct;
  recording.subject = distinct[chosen];
  if (!wanted)
    recording.notes.push_back("The file holds " + std::to_string(distinct.size()) + " figures (" +
                              listed(distinct) + "); that of " + in_quotes(distinct[chosen]) +
                              " is used, because it has the most joints and no subject was "
                              "chosen.");
  return chosen;
}

}  // namespace mien::motion
