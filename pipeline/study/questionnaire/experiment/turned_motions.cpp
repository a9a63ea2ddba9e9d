#include "pipeline/study/questionnaire/experiment/turned_motions.h"

#include <system_error>
#include <utility>

#include "motion/skeleton/body.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/manifest/person_figure.h"
#include "pipeline/study/figures/figure_message.h"
#include "pipeline/study/figures/shown_people.h"

namespace mien::pipeline {

TurnedMotions::TurnedMotions(const Manifest& manifest, std::filesystem::path folder)
    : folder_(std::move(folder)), motions_(manifest) {}

std::optional<TurnedMotion> TurnedMotions::of(const Stimulus& stimulus, const std::string& token) {
  const bool is_alone = stimulus.people.empty();
  if (is_alone && !can_be_turned(stimulus.look.figure)) return std::nullopt;
  const ShownPeople shown = shown_people(stimulus, motions_);
  if (is_alone && !motion::is_body(shown.people.front().clip.body)) return std::nullopt;
  PeopleMessage message = people_message(shown, figures_);
  TurnedMotion turned = {.file = folder_ / (token + ".people")};
  for (const std::string& glb : message.files) {
    turned.figures.push_back(figure_file(glb));
    message.head["figures"].push_back(turned.figures.back().token);
  }
  write(turned.file, framed(message.head, message.bytes));
  return turned;
}

FigureFile TurnedMotions::figure_file(const std::string& glb) {
  const std::string sha256 = sha256_of(glb);
  const std::string token = "f" + sha256.substr(0, 14);
  const FigureFile file = {.file = folder_ / (token + ".glb"), .token = token, .sha256 = sha256};
  write(file.file, glb);
  return file;
}

void TurnedMotions::write(const std::filesystem::path& file, const std::string& bytes) {
  if (!written_.insert(file).second) return;
  std::error_code unknown;
  // A server may be sending it.
  if (std::filesystem::is_regular_file(file, unknown) && read_file(file) == bytes) return;
  make_folder(folder_);
  write_file(file, bytes);
}

}  // namespace mien::pipeline
