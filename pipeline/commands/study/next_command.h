#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/study/answer_inputs.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/adaptive/next_films.h"
#include "pipeline/study/adaptive/round_methods.h"

namespace mien::pipeline {

/// The arguments of `mien study next`.
struct NextCommand {
  std::vector<std::string> files;  ///< answers, and the manifest
  std::string out;
  std::optional<int> films, pairs;
  std::optional<int> candidates;
  std::string highest, lowest;
  std::vector<std::string> scales, features;
  std::optional<std::uint64_t> seed;
  std::string name;
  std::string tables;
  std::string show;
  std::string methods;
};

/// Number of films or pairs, if it is not given.
inline constexpr int usual_next_count = 12;

FilmAim aim_of(const NextCommand& command);

/// The scales that count: those that are named, and that of the aim, or all that are asked. Throws
/// Error for one that is not asked.
std::vector<std::string> asked_scales(const NextCommand& command, const Manifest& manifest);

/// The answers' files in the order given. A file with the same content as an earlier one is left
/// out with a note. Throws Error if one does not exist.
std::vector<std::filesystem::path> distinct_files(const std::vector<std::filesystem::path>& files,
                                                  const Console& console);

/// The name of the next study, or of the first if nothing has been answered.
std::string next_name(const NextCommand& command, const Manifest& manifest, bool is_first = false);

/// The manifest's text. Throws Faults if the manifest would have some, as when the questionnaire
/// refers to levels of factors that new films do not have, and Error if the file holds something
/// else.
std::string checked_next_yaml(const NextCommand& command, const Manifest& round,
                              const std::string& comment);

/// Writes the tables, if they are wanted, and prints their names.
void write_next_tables(const NextCommand& command, const std::vector<WrittenTable>& tables,
                       const Console& console);

/// Throws Error if a file of the paragraph or its references holds something else, such as the
/// bibliography of a paper.
void refuse_other_methods(const NextCommand& command, const RoundMethods& methods);

/// Writes the paragraph, if it is wanted, with its references beside it, and prints their names.
void write_next_methods(const NextCommand& command, const RoundMethods& methods,
                        const Console& console);

/// Chooses films for a manifest of ratings, or pairs for one of pairs (next_pairs.cpp).
int choose_next_films(const NextCommand& command, const AnswerInputs& inputs,
                      const Manifest& manifest, const Console& console);
int choose_next_pairs(const NextCommand& command, const AnswerInputs& inputs,
                      const Manifest& manifest, const Console& console);

}  // namespace mien::pipeline
