#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/error.h"

namespace mien::motion {

/// Names of the people of a file as they can be asked for: a person without a name is "subject 2"
/// by their place in the file, and a second one named "Anna" is "Anna 2". If all are names of roots
/// that end alike, as in "Anna_Hips" and "Ben_Hips", they are "Anna" and "Ben".
std::vector<std::string> subject_names(const std::vector<std::string>& given);

/// Index of the person that is asked for by name or, if nobody has that name, by number from 1;
/// the first if nobody is asked for. There is at least one name. Throws mien::Error at `place`,
/// with the names, if there is no such person.
std::size_t chosen_subject(const Place& place, const std::vector<std::string>& names,
                           const std::optional<std::string>& wanted);

/// A sentence on the choice of one of several people, for `notes`; empty if there was no choice or
/// if it was asked for.
std::string note_on_subject(const std::vector<std::string>& names, std::size_t chosen,
                            const std::optional<std::string>& wanted);

}  // namespace mien::motion
