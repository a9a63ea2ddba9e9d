#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/study/chain_design.h"
#include "pipeline/commands/study/frozen_archive.h"
#include "pipeline/commands/study/matching_design.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/commands/study/planned_tests.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/production/run/continuous_films.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/study/power/power_output.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/power.h"
#include "pipeline/study/questionnaire/session_duration.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct DesignCommand {
  std::string manifest;
  int participants = 0;
  std::string plans;
  std::string balance;
  bool power = false;
  std::string ratings;
  std::vector<double> spread;
  std::vector<std::string> between;
  PowerOptions question;
  PlannedTestsCommand planned;
  std::string frozen;
  std::string out = "out";
};

/// Joins the parts of "made=acted,modified", which was split at the comma.
void take_between(const std::vector<std::string>& parts, PowerOptions& question) {
  if (parts.empty()) return;
  const std::size_t equals = parts[0].find('=');
  if (parts.size() != 2 || equals == std::string::npos)
    throw Error("--between takes a factor and two of its levels",
                "for example made=acted,modified");
  question.factor = parts[0].substr(0, equals);
  question.level = parts[0].substr(equals + 1);
  question.other_level = parts[1];
}

/// The variance of ratings on each scale that the questionnaire asks, or the stated one, which has
/// no scale.
std::vector<ScaleSpread> spreads_of(const DesignCommand& command, const Manifest& manifest) {
  if (!command.ratings.empty() && !command.spread.empty())
    throw Error("--ratings and --spread both specify the variance of ratings",
                "give one of the two");
  if (!command.ratings.empty()) {
    std::vector<ScaleSpread> spreads =
        spreads_of(read_answers(command.ratings, scales_to_choose(manifest)));
    const ScaleSet asked = questionnaire_scales(manifest);
    std::erase_if(spreads, [&](const ScaleSpread& one) {
      return std::ranges::find(asked.scales, one.scale, &Scale::id) == asked.scales.end();
    });
    if (!spreads.empty()) return spreads;
    throw Error({command.ratings}, "has no ratings on the scales of this questionnaire",
                "give ratings on the scales that are asked, or --spread");
  }
  if (command.spread.empty()) return {{"", {}}};
  return {{"",
           {command.spread[0], command.spread[1], command.spread[2],
            command.spread.size() > 3 ? command.spread[3] : 0.0}}};
}

/// The power for one scale; without a name, for ratings in general.
void print_power_of(const ScaleSpread& scale, PowerOptions question, const Manifest& manifest,
                    const Console& console, std::ostream& out) {
  question.spread = scale.spread;
  const PowerEstimate estimate = estimate_power(manifest, question);
  out << '\n';
  if (!scale.scale.empty()) out << scale.scale << ":\n";
  for (const std::string& sentence : power_sentences(question, estimate)) out << sentence << '\n';
  if (is_false_positive_rate_inflated(question, estimate))
    console.err << fmt::format(
        "warning: {}the false-positive rate of the simulated studies is {:.0f} % instead of {:g} "
        "%; do not rely on this power estimate\n",
        scale.scale.empty() ? "" : scale.scale + ": ", 100.0 * estimate.false_positives.share,
        100.0 * question.alpha);
}

void print_power(const DesignCommand& command, const Manifest& manifest, const Console& console,
                 std::ostream& out) {
  PowerOptions question = command.question;
  question.seed = manifest.seed;
  take_between(command.between, question);
  for (const ScaleSpread& scale : spreads_of(command, manifest))
    print_power_of(scale, question, manifest, console, out);
}

/// Refuses to assume the usual standard deviations and difference, those of scales from -2 to 2, on
/// other scales.
void refuse_usual_spread(const DesignCommand& command, const Manifest& manifest) {
  if (!command.power || !command.ratings.empty() || !command.spread.empty()) return;
  const ScaleSet asked = questionnaire_scales(manifest);
  const auto other = std::ranges::find_if(asked.scales, [](const Scale& scale) {
    return std::abs(scale.most - scale.least - 4.0) > 1e-9;
  });
  if (other == asked.scales.end()) return;
  const RatingSpread usual;
  const double points = (other->most - other->least) / 4.0;
  throw Error(
      fmt::format("{} goes from {:g} to {:g}, and --power knows usual standard deviations and a "
                  "usual difference for scales from -2 to 2 only",
                  other->id, other->least, other->most),
      fmt::format("state them in points of the scale; those of scales from -2 to 2 are, by range, "
                  "--spread {:g},{:g},{:g}",
                  points * usual.participant, points * usual.stimulus, points * usual.residual) +
          (command.planned.truth.empty()
               ? fmt::format(" --difference {:g}", points * PowerOptions().difference)
               : ""));
}

/// The planned tests, simulated with the assumptions of the command.
std::optional<PlannedTestsResult> planned_tests_of(const DesignCommand& command,
                                                   const Manifest& manifest,
                                                   const Console& console) {
  if (command.planned.table.empty()) return std::nullopt;
  return simulate_planned_tests(command.planned,
                                {.spreads = spreads_of(command, manifest),
                                 .difference = command.question.difference,
                                 .studies = command.question.studies,
                                 .seed = manifest.seed},
                                manifest, console);
}

/// "at most " if tracks may end before all planned trials were shown.
std::string bound_text(const Manifest& manifest) {
  return questionnaire_of(manifest).adaptive.may_end_early() ? "at most " : "";
}

void print_duration(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                    const Console& console, std::ostream& out) {
  const auto longest = std::ranges::max_element(plans, {}, &SessionPlan::expected_seconds);
  out << "Expected duration of a session: " << bound_text(manifest) << duration_text(plans)
      << ".\n";
  if (longest->expected_seconds <= recommended_session_seconds) return;
  console.err << "warning: a session of more than "
              << fmt::format("{:g} min", recommended_session_seconds / 60.0)
              << " is long; show each participant fewer stimuli (questionnaire.per_participant) or "
                 "ask fewer scales\n";
}

/// "46 trials each: 40 analysed, 2 for practice, 4 attention checks"; ranges where sessions differ.
std::string trials_text(const std::vector<SessionPlan>& plans) {
  const auto counted = [&](auto&& is_such) {
    std::ptrdiff_t least = std::ranges::count_if(plans[0].trials, is_such), most = least;
    for (const SessionPlan& plan : plans) {
      const std::ptrdiff_t count = std::ranges::count_if(plan.trials, is_such);
      least = std::min(least, count);
      most = std::max(most, count);
    }
    return least == most ? std::to_string(most) : fmt::format("{} to {}", least, most);
  };
  const std::string all = counted([](const Trial&) { return true; });
  const std::string number_of_trials = all + (all == "1" ? " trial" : " trials");
  std::string text = fmt::format("{} each: {} analysed", number_of_trials,
                                 counted([](const Trial& trial) { return trial.is_analysed(); }));
  const auto add = [&](const std::string& count, const char* what) {
    if (count != "0") text += fmt::format(", {} {}", count, what);
  };
  add(counted([](const Trial& trial) { return trial.practice; }), "for practice");
  add(counted([](const Trial& trial) { return trial.warm_up; }), "to warm up");
  add(counted([](const Trial& trial) { return trial.is_check && !trial.is_attention_check(); }),
      "repeated");
  const std::string checks = counted([](const Trial& trial) { return trial.is_attention_check(); });
  add(checks, checks == "1" ? "attention check" : "attention checks");
  return text;
}

void print_design(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                  const Balance& balance, const Console& console, std::ostream& out) {
  out << fmt::format("{}: {}, {}{}\n", manifest.study,
                     counted_noun(plans.size(), "participant", "participants"),
                     bound_text(manifest), trials_text(plans));
  for (const std::string& sentence :
       balance_sentences(manifest, balance, static_cast<int>(plans.size())))
    out << sentence << '\n';
  print_duration(manifest, plans, console, out);
}

/// Input files of the tables and the archive, which must not be overwritten.
std::vector<fs::path> files_of_design(const DesignCommand& command, const Manifest& manifest) {
  std::vector<fs::path> files = {fs::path(command.ratings), fs::path(command.planned.truth)};
  for (const InputCopy& input : input_copies(manifest)) files.push_back(input.source);
  return files;
}

int design(const DesignCommand& command, const Console& console) {
  Manifest manifest = participants_manifest(command.manifest, console);
  if (manifest.matching || manifest.adaptive) {
    if (command.power || !command.balance.empty())
      throw Error("--power and --balance apply to questionnaires only",
                  "omit them for an experiment");
    if (manifest.adaptive)
      return design_chains(manifest, {command.participants, command.plans, command.frozen},
                           console);
    if (!command.frozen.empty())
      throw Error("--freeze does not apply to matching experiments", "omit it");
    return design_matching(manifest, {command.participants, command.plans}, console);
  }
  if (command.participants > 0) manifest.questionnaire->participants = command.participants;
  if (command.power && !manifest.questionnaire->adaptive.empty())
    throw Error("the power of thresholds is not estimated",
                "leave --power out, and try sizes by mien study simulate --participants and mien "
                "study report");
  const VideoSeconds seconds = video_seconds(manifest);
  check_continuous_films(manifest, seconds);
  const std::vector<SessionPlan> plans = plan_sessions(manifest, seconds);
  const Balance balance = balance_of(manifest, plans);
  std::vector<NewTable> tables = {{command.plans, plans_csv(plans)},
                                  {command.balance, balance_csv(balance)}};
  if (!command.planned.table.empty()) {
    tables.push_back({command.planned.table, power_table({}).csv});
    refuse_figure_loss(command.planned);
  }
  refuse_data_loss(tables, files_of_design(command, manifest), command.frozen);
  refuse_usual_spread(command, manifest);
  const std::optional<PlannedTestsResult> tests = planned_tests_of(command, manifest, console);
  if (tests) tables.back().csv = power_table(tests->rows).csv;
  std::ostringstream power;  // printed, and a file of the archive
  if (tests)
    print_planned_tests(*tests, command.question.wanted_power, manifest, power);
  else if (command.power)
    print_power(command, manifest, console, power);
  ZipFiles power_files;
  if (command.power) power_files["power.txt"] = power.str().substr(1);  // without an empty line
  if (tests) power_files["planned-tests.csv"] = tables.back().csv;
  std::optional<FrozenArchive> archive;
  if (!command.frozen.empty())
    archive = frozen_archive(manifest, plans, power_files, fs::path(command.out) / manifest.study,
                             command.frozen);
  // The plans go to standard output unless a file is given; messages then go to standard error.
  std::ostream& out = command.plans.empty() ? console.err : console.out;
  if (command.plans.empty()) console.out << tables[0].csv;
  print_design(manifest, plans, balance, console, out);
  print_warnings(questionnaire_warnings(manifest), console);
  out << power.str();
  if (archive) {
    remark_on_archive(manifest, command.power, console);
    write_archive(*archive);
    out << command.frozen << ": " << archive->files << " files\n";
  }
  for (const NewTable& table : tables) {
    if (table.file.empty()) continue;
    write_file(table.file, table.csv);
    out << table.file.string() << '\n';
  }
  if (tests)
    write_power_figure(command.planned, *tests, command.question.wanted_power, manifest, out);
  return exit_done;
}

std::vector<CommandOption> power_options(DesignCommand& options) {
  return {
      flag("--power", &options.power, "Estimate power and sample size with simulated raters"),
      option("--ratings", &options.ratings,
             "With --power: answers (CSV) from which the raters' variances are estimated")
          .needs("--power"),
      option("--spread", &options.spread,
             "With --power: standard deviations of participants, stimuli and residual and, for "
             "--planned-tests, of participants in the cells of the design, in scale points "
             "[0.5,0.5,0.8,0]")
          .needs("--power")
          .with_commas()
          .values(3, 4)
          .between(0.0, 1000.0),
      option("--difference", &options.question.difference,
             "With --power: the difference to be detected, in scale units (most scales go from -2 "
             "to 2)")
          .needs("--power")
          .positive()
          .with_default(),
      option("--between", &options.between,
             "With --power: a factor and two levels to compare, such as made=acted,modified "
             "(default: any two stimuli)")
          .needs("--power")
          .with_commas(),
      option("--studies", &options.question.studies, "With --power: number of simulated studies")
          .needs("--power")
          .between(100, 1000000)
          .with_default()};
}

}  // namespace

Command study_design_command() {
  const auto options = std::make_shared<DesignCommand>();
  return {
      .name = "design",
      .summary = "Plan the sessions of all participants: order, balance, duration, power",
      .options = all_of(
          argument("manifest", &options->manifest, study_manifest_help),
          option("-o,--output", &options->plans,
                 "CSV of all participants' plans (default: standard output)"),
          option("--balance", &options->balance,
                 "CSV of how often each stimulus appears, in which position and after which other "
                 "stimulus"),
          option("--participants", &options->participants,
                 "Number of participants (default: as in the manifest)")
              .between(1, 10000),
          power_options(*options), planned_tests_options(options->planned),
          option("--freeze", &options->frozen,
                 "Archive (.zip) for a preregistration: plans, manifest, analysis plan and hashes "
                 "of all media")
              .excludes("--participants"),
          option("--out", &options->out,
                 "With --freeze: folder of all studies, in which this one was made")
              .with_default()),
      .notes =
          "The same manifest gives the same plans; adding participants does not change earlier "
          "plans.\n\n"
          "Examples:\n"
          "  mien study design emotion-study -o plans.csv --balance balance.csv\n"
          "  mien study design study.yaml -o plans.csv --power --ratings pilot.csv\n"
          "  mien study design study.yaml -o plans.csv --power --planned-tests power.csv "
          "--at-stimuli 2,4,8\n"
          "  mien study design study.yaml -o plans.csv --freeze preregistration.zip",
      .run = [options](const Console& console) { return design(*options, console); }};
}

}  // namespace mien::pipeline
