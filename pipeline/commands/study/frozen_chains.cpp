#include "pipeline/commands/study/frozen_chains.h"

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/production/archive/scratch_folder.h"
#include "pipeline/production/methods/methods.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/study/chains/experiment/chain_results.h"
#include "pipeline/study/chains/experiment/simulated_chains.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/frozen_design.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr char readme[] =
    "The design of an adaptive experiment, frozen before data collection.\n\n"
    "procedure.md         method, words, dimensions and chains, as in the methods section\n"
    "references.bib       works that it cites (BibTeX)\n"
    "analysis.txt         when the experiment ends, and how its answers are analysed\n"
    "plans.csv            every trial of every participant\n"
    "experiment.json      all sessions, with the starts of the chains\n"
    "inputs/              the manifest and the files that it names\n"
    "dummy-report/        simulated answers and their analysis\n"
    "manifest-sha256.txt  hashes of all files: sha256sum -c manifest-sha256.txt\n\n";

/// When chains end early, and what becomes of inattentive participants.
std::string rules_text(const Adaptive& adaptive) {
  std::string text;
  if (adaptive.until)
    text += fmt::format(
        "The chains of a word end once R̂ of their second halves is at most {:g} in every dimension "
        "and each of them has {} {} or more.\n",
        adaptive.until->r_hat, adaptive.until->at_least,
        adaptive.method == ChainMethod::gibbs ? "sweeps" : "choices");
  if (adaptive.attention_every > 0)
    text += fmt::format(
        "{} who fail more than {} attention {} {}.\n",
        adaptive.across_participants ? "The sessions of participants" : "Participants",
        adaptive.max_failed_checks, adaptive.max_failed_checks == 1 ? "check" : "checks",
        adaptive.across_participants
            ? "end, and their answers to incomplete steps are given by others"
            : "are left out");
  return text;
}

std::string analysis_text(const Adaptive& adaptive, const ChainDesign& design) {
  const std::size_t chains = design.words.size() * static_cast<std::size_t>(design.chains);
  std::string text =
      adaptive.across_participants
          ? fmt::format(
                "The experiment ends when each of {} chains has {} steps{}, or when {} "
                "participants "
                "have taken part. Chains are cut to the length of the shortest chain of the "
                "word.\n",
                chains, design.steps, design.until ? " or has ended before" : "",
                adaptive.participants)
          : fmt::format(
                "The experiment ends when {} participants have completed their chains, {} each of "
                "{} "
                "steps. Incomplete chains are left out.\n",
                adaptive.participants, chains, design.steps);
  text += rules_text(adaptive);
  text += fmt::format(
      "Samples are the points after each {}; the first half of each chain is left out. Reported "
      "are, "
      "for each word and dimension, mean, 95 % interval of the mean (from the means of the chains "
      "by "
      "the t distribution), standard deviation, quantiles 0.05, 0.5 and 0.95, R̂ and the effective "
      "number of samples, and for each pair of words the distance of their means, in shares of the "
      "ranges and in standard deviations of the samples.\n",
      design.method == ChainMethod::gibbs ? "sweep" : "choice");
  return text;
}

/// Adds simulated answers and what mien study chains makes of them.
void add_dummy_report(ZipFiles& files, const Adaptive& adaptive, const ChainStudy& study) {
  const ScratchFolder folder;
  write_file(
      folder.path() / "steps.csv",
      chain_steps_csv(simulated_chains(study, adaptive.across_participants, usual_truth(study)),
                      study.design));
  const ChainAnswers answers = read_chain_answers({folder.path() / "steps.csv"}, study);
  write_tables(folder.path(),
               chain_tables(chain_results(study, answers,
                                          {.across_participants = adaptive.across_participants,
                                           .max_failed_checks = adaptive.max_failed_checks})));
  add_folder(files, folder.path(), "dummy-report");
}

}  // namespace

FrozenArchive frozen_chains(const Manifest& manifest, Motions& motions, const ChainStudy& study,
                            const fs::path& file) {
  const Adaptive& adaptive = *manifest.adaptive;
  ZipFiles files;
  const Methods methods = methods_of(manifest, motions);
  files["README.txt"] =
      fmt::format("{}The hash of the design, which all tables of answers have, is {}.\n", readme,
                  study.experiment.at("design").get<std::string>());
  files["procedure.md"] = methods.markdown;
  files["references.bib"] = methods.bibtex;
  files["analysis.txt"] = analysis_text(adaptive, study.design);
  files["plans.csv"] = plans_csv(study.plans());
  files["experiment.json"] = study.experiment.dump(1) + "\n";
  for (const InputCopy& copy : input_copies(manifest))
    files[copy.path] = contents_of_copy(manifest, copy);
  add_dummy_report(files, adaptive, study);
  FrozenArchive archive{.file = file, .bytes = zip_of(files), .files = files.size()};
  refuse_other_content(file, archive.bytes);
  return archive;
}

}  // namespace mien::pipeline
