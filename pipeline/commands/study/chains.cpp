#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/study/answer_inputs.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/study/analysis/scales_yaml.h"
#include "pipeline/study/chains/experiment/chain_dataset.h"
#include "pipeline/study/chains/experiment/chain_results.h"
#include "pipeline/study/chains/experiment/word_prototypes.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr char prototypes_comment[] = "# Prototypes of words, made by mien study chains";

struct ChainsCommand {
  std::vector<std::string> files;  ///< answers, and the manifest
  std::string out;
  int discarded = -1;
};

std::string number_text(double value, const char* form) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(form), value) : "–";
}

void show(const ChainResults& results, const Console& console) {
  if (results.simulated) console.out << "simulated answers\n";
  for (const WordSamples& word : results.words) {
    const int sweeps = word.discarded + word.samples / word.chains;
    console.out << fmt::format(
        "{}: {}, {} ({} {} to {})\n", word.word,
        counted_noun(static_cast<std::size_t>(word.chains), "chain", "chains"),
        counted_noun(static_cast<std::size_t>(word.samples), "sample", "samples"),
        results.design.method == ChainMethod::gibbs ? "sweeps" : "choices", word.discarded + 1,
        sweeps);
    for (std::size_t d = 0; d < word.dimensions.size(); ++d) {
      const DimensionSamples& of = word.dimensions[d];
      const bool has_ends = std::isfinite(of.mean.ends.low);
      console.out << fmt::format(
          "  {:28} {:.3f} {:16} SD {:5}  R̂ {}\n", results.design.dimensions[d], of.mean.mean,
          has_ends ? fmt::format("[{:.3f}, {:.3f}]", of.mean.ends.low, of.mean.ends.high) : "",
          number_text(of.deviation, "{:.3f}"), number_text(of.r_hat, "{:.2f}"));
    }
  }
  for (const WordDistance& one : results.distances)
    console.out << fmt::format("{} and {}: {:.2f} of the ranges apart{}\n", one.first, one.second,
                               one.distance,
                               std::isfinite(one.standardised)
                                   ? fmt::format(" ({:.1f} standard deviations)", one.standardised)
                                   : "");
}

/// What may make results useless, on standard error.
void remark(const ChainResults& results, const Adaptive& adaptive, const Console& console) {
  if (results.incomplete > 0)
    console.err << fmt::format(
        "note: {} not complete and left out\n",
        counted_noun(static_cast<std::size_t>(results.incomplete), "chain is", "chains are"));
  if (!results.inattentive.empty())
    console.err << fmt::format(
        "note: {} failed too many attention checks{}\n", fmt::join(results.inattentive, ", "),
        adaptive.across_participants      ? "; answers before that are part of the chains"
        : results.inattentive.size() == 1 ? " and is left out"
                                          : " and are left out");
  if (results.design.until)
    for (const WordSamples& word : results.words) {
      double largest = 0.0;
      for (const DimensionSamples& of : word.dimensions) largest = std::max(largest, of.r_hat);
      if (largest > results.design.until->r_hat)
        console.err << fmt::format(
            "note: the chains of {} have not reached the R̂ of until: it is up to {:.2f}, above "
            "{:g}\n",
            word.word, largest, results.design.until->r_hat);
    }
  for (const WordSamples& word : results.words) {
    double worst = 0.0;
    for (const DimensionSamples& of : word.dimensions)
      if (are_different(of.values)) worst = std::max(worst, of.r_hat);
    if (worst > 0.0)
      console.err << fmt::format(
          "warning: the chains of {} have not converged to the same distribution (R̂ up to "
          "{:.2f}); its prototype depends on where they started\n",
          word.word, worst);
  }
}

/// Manifest, scales and ratings: names and contents.
std::vector<NewTable> prototype_files(const Manifest& manifest, const ChainStudy& study,
                                      const ChainResults& results, const fs::path& folder) {
  const ScaleSet scales = word_scales(manifest);
  const std::string head =
      "The words of an adaptive experiment as scales, made by mien study chains";
  Manifest prototypes =
      prototype_manifest(manifest, study, results, fs::absolute(folder / "words.scales.yaml"));
  std::string comment = prototypes_comment;
  comment += results.simulated ? " from simulated answers.\n" : ".\n";
  std::vector<NewTable> files = {
      {folder / "prototypes.yaml", comment + manifest_yaml(prototypes, folder)},
      {folder / "words.scales.yaml", to_yaml(scales, head)}};
  if (study.dimensions.kind != motion::InterfaceKind::modifications)
    files.push_back({folder / "words.ratings.csv", word_ratings_csv(study, results, scales)});
  return files;
}

/// Throws Error for a folder with files that an earlier analysis has not written.
void refuse_other_folder(const fs::path& folder) {
  if (!fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder))) return;
  const fs::path mark = folder / "prototypes.yaml";
  const bool is_ours = fs::is_regular_file(mark) && read_file(mark).starts_with(prototypes_comment);
  if (!is_ours)
    throw Error({folder.string()}, "exists and has no results of chains",
                "name a new or empty folder");
}

int analyse_chains(const ChainsCommand& command, const Console& console) {
  const fs::path folder = command.out;
  refuse_other_folder(folder);
  const AnswerInputs inputs = answer_inputs(command.files);
  const Manifest manifest = participants_manifest(inputs.manifest.string(), console);
  const Adaptive& adaptive = adaptive_of(manifest);
  Motions motions(manifest);
  const ChainStudy study = chain_study(manifest, motions);
  const ChainAnswers answers = read_chain_answers(inputs.answers, study);
  const ChainResults results = chain_results(study, answers,
                                             {.discarded = command.discarded,
                                              .across_participants = adaptive.across_participants,
                                              .max_failed_checks = adaptive.max_failed_checks});
  const std::vector<NewTable> files = prototype_files(manifest, study, results, folder);
  make_folder(folder);
  // They mark the folder as one of results, also if the rest is not written.
  for (const NewTable& file : files) write_file(file.file, file.csv);
  const std::vector<WrittenTable> tables = chain_tables(results);
  write_tables(folder, tables);
  for (const auto& [name, bytes] :
       chain_dataset(manifest.study, inputs.answers, tables, results.simulated)) {
    make_folder((folder / name).parent_path());
    write_file(folder / name, bytes);
  }
  write_plot(chains_plot(results), folder, "chains");
  write_plot(prototypes_plot(results), folder, "prototypes");
  write_plot(densities_plot(results), folder, "densities");
  show(results, console);
  remark(results, adaptive, console);
  console.out << folder.string() << '\n';
  return exit_done;
}

}  // namespace

Command study_chains_command() {
  const auto options = std::make_shared<ChainsCommand>();
  return {
      .name = "chains",
      .summary =
          "Analyse an adaptive experiment: what each word looks like, and whether chains "
          "agree",
      .options = {argument("files", &options->files,
                           "Answers (tables of steps, CSV), and the study's manifest"),
                  option("-o,--output", &options->out, "Folder for the results").required(),
                  option(
                      "--discard", &options->discarded,
                      "Sweeps (of choices: steps) at the beginning of each chain that are not used "
                      "as samples (default: the first half)")
                      .between(0, 1000)},
      .notes =
          "Writes the answers (data), samples.csv, prototypes.csv, densities.csv and distances.csv "
          "with a codebook,\n"
          "the figures chains, prototypes and densities as .pdf, .svg and .png, and what manifests "
          "take:\n"
          "words.scales.yaml and words.ratings.csv for examples, so that stimuli can have "
          "adjectives: {sad: 0.8}\n"
          "(not of modifications of one motion), "
          "and prototypes.yaml, which makes a film of each word and asks for ratings of them.\n\n"
          "Examples:\n"
          "  mien study simulate gibbs-words -o steps.csv\n"
          "  mien study chains gibbs-words steps.csv -o chains\n"
          "  mien run chains/prototypes.yaml",
      .run = [options](const Console& console) { return analyse_chains(*options, console); }};
}

}  // namespace mien::pipeline
