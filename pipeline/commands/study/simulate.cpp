#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/examples_option.h"
#include "pipeline/commands/study/matching_design.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reading/example_source.h"
#include "pipeline/production/run/continuous_films.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/chains/experiment/simulated_chains.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/session_duration.h"
#include "pipeline/study/questionnaire/simulated_people.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/results/answer_files.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct SimulateCommand {
  std::string manifest;
  std::string examples;
  RecordingArguments recording;  ///< how the files of the examples are read
  std::string scales;
  std::string truth;
  std::string out;
  int raters = 14;
  std::uint64_t seed = 0;
  int participants = 0;
  SimulatedParticipants people;
  std::optional<double> participant_sd, residual_sd;
};

SimulatedParticipants people_of(const SimulateCommand& command, const Manifest& manifest) {
  SimulatedParticipants people = command.people;
  const TrialForm& form = *questionnaire_of(manifest).trials;
  if (form.is_continuous) {
    people.film_seconds = video_seconds(manifest);
    check_continuous_films(manifest, people.film_seconds);
  }
  if (command.participant_sd || command.residual_sd) {
    const ScaleSet scales = questionnaire_scales(manifest);
    const double range =
        scales.scales.empty() ? 4.0 : scales.scales.front().most - scales.scales.front().least;
    people.spread = usual_spread(range);
    if (command.participant_sd) people.spread->participant = *command.participant_sd;
    if (command.residual_sd) people.spread->residual = *command.residual_sd;
  }
  return people;
}

/// Input files of the simulation, which must not be overwritten.
std::vector<fs::path> files_simulated_from(const SimulateCommand& command,
                                           const Manifest& manifest) {
  std::vector<fs::path> files = {fs::path(command.truth), fs::path(command.scales)};
  if (manifest.file.empty()) return files;
  for (const InputCopy& input : input_copies(manifest)) files.push_back(input.source);
  return files;
}

/// Writes the answers to the file, or to standard output if none is given, and states that they are
/// simulated.
int put_answers(const SimulateCommand& command, const Manifest& manifest, const std::string& csv,
                const std::string& whose, const Console& console,
                const std::string& participants = "") {
  if (command.out.empty()) {
    console.out << csv;
    return exit_done;
  }
  std::vector<NewTable> tables = {{command.out, csv}};
  if (!participants.empty()) tables.push_back({participants_of(command.out), participants});
  refuse_data_loss(tables, files_simulated_from(command, manifest));
  for (const NewTable& table : tables) write_file(table.file, table.csv);
  console.out << command.out << ": answers of " << whose << '\n';
  if (!participants.empty())
    console.out << tables.back().file.string()
                << ": their answers to the questions about participants\n";
  return exit_done;
}

int simulate_examples(const SimulateCommand& command, const Console& console) {
  Manifest manifest;
  manifest.examples = examples_of(command.examples, command.recording);
  if (!command.scales.empty()) manifest.scales = scales_in(command.scales);
  manifest.ratings.source = Ratings::Source::simulated;
  manifest.ratings.raters = command.raters;
  manifest.seed = command.seed;
  return put_answers(command, manifest, to_csv(simulated_answers(manifest)),
                     fmt::format("{} simulated raters", command.raters), console);
}

/// What is stated of the psychometric functions applies to adaptive trials only, and these need no
/// other truth.
void check_observer_options(const SimulateCommand& command, const Manifest& manifest) {
  const bool is_adaptive = !questionnaire_of(manifest).adaptive.empty();
  const SimulatedObservers& stated = command.people.observers;
  if (!is_adaptive && (stated.threshold || stated.threshold_deviation || stated.width))
    throw Error("--threshold, --threshold-sd and --width apply to adaptive trials only",
                "omit them, or add adaptive: {factor: …} to the questionnaire");
  if (is_adaptive && !command.truth.empty())
    throw Error("adaptive trials are simulated with a psychometric function, not with --truth",
                "state --threshold and --width");
}

/// The stated truth; not required if there are only emotions and choices in words.
AssumedTruth truth_of(const SimulateCommand& command, const Manifest& manifest) {
  if (!command.truth.empty()) return read_truth(manifest, command.truth);
  if (questionnaire_scales(manifest).scales.empty()) return {};
  refuse_scales_without_model(manifest);
  return measured_truth(manifest);
}

int simulate_matched(const SimulateCommand& command, const Manifest& manifest,
                     const Console& console) {
  if (!command.truth.empty())
    throw Error("--truth applies to questionnaires only", "omit it for a matching experiment");
  Motions motions(manifest);
  const MatchingStudy study = matching_study(manifest, motions, command.participants);
  warn_of_matched_at_start(manifest, study, console);
  const std::vector<MatchedTrial> trials = simulated_matching(manifest, motions, study);
  return put_answers(
      command, manifest, matching_trials_csv(trials),
      fmt::format("{} simulated participants, {} trials", study.plans.size(), trials.size()),
      console);
}

int simulate_chains(const SimulateCommand& command, const Manifest& manifest,
                    const Console& console) {
  if (!command.truth.empty())
    throw Error("--truth applies to questionnaires only", "omit it for an adaptive experiment");
  Motions motions(manifest);
  const ChainStudy study = chain_study(manifest, motions, command.participants);
  const std::vector<ChainAnswer> answers =
      simulated_chains(study, manifest.adaptive->across_participants, usual_truth(study),
                       command.people.attention_pass_rate);
  return put_answers(
      command, manifest, chain_steps_csv(answers, study.design),
      fmt::format("{} simulated participants, {} trials", study.sessions.size(), answers.size()),
      console);
}

int simulate_questionnaire(const SimulateCommand& command, const Console& console) {
  const Manifest manifest = participants_manifest(command.manifest, console);
  if (manifest.matching) return simulate_matched(command, manifest, console);
  if (manifest.adaptive) return simulate_chains(command, manifest, console);
  check_observer_options(command, manifest);
  const std::vector<SessionPlan> plans = plan_sessions(manifest, {}, command.participants);
  const AssumedTruth truth = truth_of(command, manifest);
  const std::vector<AnswerRow> rows = simulated_sessions(
      manifest, plans, truth.ratings, people_of(command, manifest), truth.courses);
  return put_answers(
      command, manifest, to_csv(rows),
      fmt::format("{}, {} rows",
                  counted_noun(plans.size(), "simulated participant", "simulated participants"),
                  rows.size()),
      console, asks_about_participants(manifest) ? simulated_people_csv(manifest, plans) : "");
}

int simulate(const SimulateCommand& command, const Console& console) {
  if (command.manifest.empty() == command.examples.empty())
    throw Error("simulate takes a manifest with a questionnaire or an experiment, or --examples",
                "give one of the two");
  return command.manifest.empty() ? simulate_examples(command, console)
                                  : simulate_questionnaire(command, console);
}

std::vector<CommandOption> simulation_options(SimulateCommand& options) {
  return {option("--truth", &options.truth,
                 "CSV (stimulus, scale, value; in continuous trials also from_s, the second of the "
                 "video from which a value holds) of true mean ratings (default: derived from the "
                 "motions by simulated raters)"),
          option("--participants", &options.participants,
                 "Number of participants (default: as in the manifest)")
              .between(1, 10000),
          option("--participant-sd", &options.participant_sd,
                 "Standard deviation of participants' response bias, in scale units (most scales "
                 "go from -2 to 2, those of grid and continuous trials from 0 to 100)")
              .formerly("--lean")
              .between(0.0, 1000.0)
              .with_default("7.5 % of the range: 0.3 from -2 to 2"),
          option("--residual-sd", &options.residual_sd,
                 "Residual standard deviation of an answer, in scale units")
              .formerly("--residual")
              .between(0.0, 1000.0)
              .with_default("17.5 % of the range: 0.7 from -2 to 2"),
          option("--reaction-lag", &options.people.reaction_lag_s,
                 "In continuous trials: seconds between what is seen and its rating")
              .between(0.0, 60.0)
              .with_default(),
          option("--threshold", &options.people.observers.threshold,
                 "In adaptive trials: mean threshold of the participants, as a level of the factor")
              .with_default("the middle of the levels"),
          option("--threshold-sd", &options.people.observers.threshold_deviation,
                 "Standard deviation of their thresholds")
              .between(0.0, 1e6)
              .with_default("a tenth of the range of the levels"),
          option("--width", &options.people.observers.width,
                 "Width of their psychometric functions: the reciprocal of the logistic's rate")
              .positive()
              .with_default("a tenth of the range of the levels"),
          option("--guess", &options.people.observers.guess,
                 "In adaptive yes_no and same_different trials: rate of positive answers without "
                 "the signal")
              .between(0.0, 0.9)
              .with_default(),
          option("--lapse", &options.people.observers.lapse,
                 "In adaptive trials: rate of negative answers however strong the signal is")
              .between(0.0, 0.5)
              .with_default(),
          option("--attentive", &options.people.attention_pass_rate,
                 "Proportion of attention checks passed")
              .between(0.0, 1.0)
              .with_default()};
}

}  // namespace

Command study_simulate_command() {
  const auto options = std::make_shared<SimulateCommand>();
  return {
      .name = "simulate",
      .summary = "Simulate answers to a questionnaire or an experiment, or ratings of examples",
      .options = all_of(
          argument("manifest", &options->manifest, study_manifest_help).optional(),
          simulation_options(*options),
          option(
              "--examples", &options->examples,
              std::string("Rate examples instead of answering a questionnaire: ") + examples_help),
          that_need("--examples", recording_options(options->recording)),
          option("--scales", &options->scales,
                 "With --examples: scales file (YAML) (default: the 41 built-in adjective pairs)"),
          option("--raters", &options->raters, "With --examples: number of raters")
              .between(2, 1000)
              .with_default(),
          option("--seed", &options->seed, "With --examples: random seed").with_default(),
          option("-o,--output", &options->out, "CSV to write (default: standard output)")),
      .notes =
          "Every row is marked as simulated.\n\nExamples:\n"
          "  mien study simulate emotion-study -o answers.csv\n"
          "  mien study simulate study.yaml --truth truth.csv --participants 40 -o answers.csv\n"
          "  mien study simulate matching-experiment -o trials.csv\n"
          "  mien study simulate --examples builtin:walks-27 -o answers.csv\n"
          "  mien study simulate --examples 'captures/*walk*.bvh' --scales five.scales.yaml",
      .run = [options](const Console& console) { return simulate(*options, console); }};
}

}  // namespace mien::pipeline
