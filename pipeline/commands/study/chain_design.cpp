#include "pipeline/commands/study/chain_design.h"

#include <optional>
#include <ostream>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/study/frozen_chains.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/study/chains/experiment/chain_study.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/session_duration.h"

namespace mien::pipeline {

namespace {

void print_across(const Manifest& manifest, const ChainStudy& study, std::ostream& out) {
  const Adaptive& adaptive = *manifest.adaptive;
  const std::size_t chains = study.design.words.size() * static_cast<std::size_t>(adaptive.chains);
  const std::size_t needed = chains * static_cast<std::size_t>(study.design.steps) *
                             static_cast<std::size_t>(adaptive.people_per_step);
  const std::size_t given =
      study.sessions.size() * static_cast<std::size_t>(adaptive.trials_per_participant);
  const char* at_most = study.design.until ? "at most " : "";
  out << fmt::format(
      "{} chains across participants, of {}{} steps each: {}{} answers are needed, and {} "
      "participants give at most {}.\n",
      chains, at_most, study.design.steps, at_most, needed, study.sessions.size(), given);
  if (given < needed)
    out << fmt::format("The chains {} not be complete; plan for at least {} participants.\n",
                       study.design.until ? "may" : "will",
                       (needed + static_cast<std::size_t>(adaptive.trials_per_participant) - 1) /
                           static_cast<std::size_t>(adaptive.trials_per_participant));
  out << fmt::format("At most {} participants can have a step at the same time; others wait.\n",
                     chains * static_cast<std::size_t>(adaptive.people_per_step));
}

void print_chains(const Manifest& manifest, const ChainStudy& study, std::ostream& out) {
  const Adaptive& adaptive = *manifest.adaptive;
  const std::vector<SessionPlan> plans = study.plans();
  const bool is_gibbs = adaptive.method == ChainMethod::gibbs;
  out << fmt::format("{}: {} participants, {} trials each, {} of them practice\n", manifest.study,
                     plans.size(), plans[0].trials.size(), adaptive.practice);
  if (adaptive.across_participants)
    print_across(manifest, study, out);
  else
    out << fmt::format(
        "Each participant has {} for each of {} words, of {} steps.\n",
        adaptive.chains == 1 ? "one chain" : fmt::format("{} chains", adaptive.chains),
        study.design.words.size(), study.design.steps);
  out << (is_gibbs ? "Dimensions, each of which is freed once in a sweep, and their ranges:\n"
                   : "Dimensions and their ranges:\n");
  for (std::size_t d = 0; d < study.design.dimensions.size(); ++d)
    out << fmt::format("  {:28} {:.3f} to {:.3f}\n", study.design.dimensions[d],
                       study.design.space[d].low, study.design.space[d].high);
  out << fmt::format("Expected duration of a session: {}, assuming 12 s per trial.\n",
                     duration_text(plans));
}

}  // namespace

int design_chains(const Manifest& manifest, const ChainDesignCommand& design,
                  const Console& console) {
  Motions motions(manifest);
  const ChainStudy study = chain_study(manifest, motions, design.participants);
  const std::string csv = plans_csv(study.plans());
  std::optional<FrozenArchive> archive;
  if (!design.frozen.empty()) archive = frozen_chains(manifest, motions, study, design.frozen);
  if (design.plans.empty()) {
    console.out << csv;
    print_chains(manifest, study, console.err);
    if (archive) write_archive(*archive);
    return exit_done;
  }
  std::vector<std::filesystem::path> read;
  for (const InputCopy& input : input_copies(manifest)) read.push_back(input.source);
  refuse_data_loss({{design.plans, csv}}, read);
  print_chains(manifest, study, console.out);
  write_file(design.plans, csv);
  console.out << design.plans.string() << '\n';
  if (!archive) return exit_done;
  write_archive(*archive);
  console.out << archive->file.string() << ": " << archive->files << " files\n";
  return exit_done;
}

}  // namespace mien::pipeline
