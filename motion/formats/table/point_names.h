#pragma once

#include <string>
#include <vector>

#include "motion/error.h"
#include "motion/formats/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Gives empty names a number ("point 3"), and the second of two equal names too ("nose 2"), so
/// that all differ.
std::vector<std::string> distinct_names(std::vector<std::string> names);

/// Index of the person that the options name, by name or by number from 1; 0 if they name none.
/// Throws mien::Error if there is no such person. `subjects` is not empty.
std::size_t chosen_subject(const std::vector<std::string>& subjects, const ReadOptions& options,
                           const Place& place);

/// "The file holds 3 people (A, B, C); A is read. Choose another with subject:."
std::string note_of_choice(const std::vector<std::string>& subjects, std::size_t chosen);

/// Where all points are named "subject:point" (people, or marker sets of objects): keeps those of
/// the subject that the options name, or that all have, under their short names. With several
/// subjects and none chosen, all points are kept under their full names, with a note. Throws
/// mien::Error if the options name a subject that is not there.
void split_subjects(PointRecording& recording, const ReadOptions& options, const Place& place);

/// The file's name without folder and extension.
std::string name_of_file(const std::string& file);

}  // namespace mien::motion
