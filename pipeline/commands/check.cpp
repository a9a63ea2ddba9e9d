#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/file_contents.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/checks/take_checks.h"
#include "pipeline/manifest/reading/levelled_document.h"
#include "pipeline/manifest/repetitions.h"
#include "pipeline/manifest/stimulus_level.h"
#include "pipeline/production/design/design_findings.h"
#include "pipeline/production/run/continuous_films.h"
#include "pipeline/production/run/rehearsal.h"
#include "pipeline/production/synthesis/parameter_request.h"

namespace mien::pipeline {

namespace {

struct CheckOptions {
  std::vector<std::string> manifests;
  std::string out = "out";
  bool quick = false;
  bool thorough = false;
  bool json = false;
};

/// Maximum number of motions of a large study that are synthesized for the check.
constexpr std::size_t most_rehearsed = 50;

/// A manifest's faults, or those of a file of scales, recipes or a set.
struct Findings {
  std::vector<Fault> faults;
  std::vector<Fault> warnings;                ///< of a manifest without faults
  std::vector<RequestedParameter> requested;  ///< of a manifest without faults
  std::vector<std::string> levels;            ///< levels_made
  std::size_t stimuli = 0;
  std::size_t rehearsed = 0;  ///< stimuli whose motions were made
};

/// A note on how many motions were checked; empty if all were.
std::string sample_note(const Findings& findings) {
  if (findings.rehearsed >= findings.stimuli) return "";
  return fmt::format("synthesized {} of {} motions as a sample; --thorough checks all",
                     findings.rehearsed, findings.stimuli);
}

nlohmann::ordered_json as_json(const Fault& fault) {
  return {{"file", fault.place.file}, {"line", fault.place.line}, {"column", fault.place.column},
          {"path", fault.path},       {"wrong", fault.wrong},     {"remedy", fault.remedy}};
}

/// Faults, warnings and notes as JSON; long lists are truncated and the number omitted is given.
class JsonFindings {
 public:
  void add(const std::string& file, const Findings& findings) {
    add("faults", findings.faults);
    add("warnings", findings.warnings);
    const auto note = [&](const std::string& text) {
      result_["notes"].push_back({{"file", file}, {"text", text}});
    };
    if (const std::string sample = sample_note(findings); !sample.empty()) note(sample);
    for (const std::string& levels : findings.levels) note(levels);
    for (const RequestedParameter& parameter : findings.requested) note(to_sentence(parameter));
  }

  std::string text() {
    if (left_out_ > 0) result_["left_out"] = left_out_;
    return result_.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }

 private:
  void add(const char* kind, const std::vector<Fault>& faults) {
    constexpr std::size_t most = 1000;
    nlohmann::ordered_json& list = result_[kind];
    for (const Fault& fault : faults) {
      if (list.size() < most) {
        list.push_back(as_json(fault));
      } else {
        ++left_out_;
      }
    }
  }

  nlohmann::ordered_json result_ = {{"faults", nlohmann::ordered_json::array()},
                                    {"warnings", nlohmann::ordered_json::array()},
                                    {"notes", nlohmann::ordered_json::array()}};
  std::size_t left_out_ = 0;
};

DocumentKind kind_of_file(const std::string& file) {
  const motion::FileReading text = motion::bytes_of_file(file, motion::max_document_bytes);
  return text.bytes ? kind_of_document(*text.bytes, file) : DocumentKind::manifest;
}

Findings findings_in(const std::string& file, const CheckOptions& options) {
  const ManifestReading reading = check_manifest(file, process_environment(), options.out);
  Findings findings{.faults = reading.faults};
  if (!findings.faults.empty()) {
    const DocumentKind kind = kind_of_file(file);
    if (kind != DocumentKind::manifest) {
      findings.faults = check_other_document(kind, file);
      return findings;
    }
  }
  append(findings.faults, check_recordings(reading.manifest));
  if (!findings.faults.empty()) {
    findings.faults = in_reading_order(std::move(findings.faults));
    return findings;
  }
  findings.levels = levels_made(reading.manifest);
  append(findings.warnings, reading.manifest.renamed);
  append(findings.warnings, default_take_warnings(reading.manifest));
  std::vector<Fault> repeated;
  for (const Repetition& repetition : repetitions_in(reading.manifest))
    repeated.push_back(repetition_fault(repetition, reading.manifest.places));
  append(findings.warnings, with_written_paths(std::move(repeated), reading.manifest.origins));
  for (Fault& warning : questionnaire_warnings(reading.manifest))
    findings.warnings.push_back(std::move(warning));
  if (options.quick) return findings;
  const Manifest rehearsed = rehearsal_sample(
      reading.manifest, options.thorough ? reading.manifest.stimuli.size() : most_rehearsed);
  Motions motions(rehearsed);
  const std::vector<std::size_t>& origins = reading.manifest.origins;
  findings.faults = with_written_paths(rehearse(rehearsed, motions), origins);
  findings.stimuli = reading.manifest.stimuli.size();
  findings.rehearsed = rehearsed.stimuli.size();
  if (!findings.faults.empty()) return findings;
  if (rehearsed.questionnaire && rehearsed.questionnaire->trials->is_continuous)
    findings.faults = continuous_film_faults(rehearsed, video_seconds(rehearsed, motions));
  if (!findings.faults.empty()) return findings;
  findings.requested = requested_parameters(reading.manifest, motions);
  std::vector<Fault> of_design;
  for (const DesignWarning& warning :
       design_warnings(rehearsed, planned_design(rehearsed, motions)))
    of_design.push_back(design_fault(warning, reading.manifest.places));
  append(findings.warnings, with_written_paths(std::move(of_design), origins));
  return findings;
}

void print_result(const Findings& findings, const std::string& file, const Console& console) {
  if (!findings.faults.empty()) console.err << fault_lines(findings.faults) << '\n';
  print_warnings(findings.warnings, console);
  if (findings.faults.empty()) console.out << file << ": no faults\n";
  for (const std::string& levels : findings.levels) console.out << levels << '\n';
  if (const std::string note = sample_note(findings); !note.empty()) console.out << note << '\n';
  console.out << feasibility_table(findings.requested);
}

int check(const CheckOptions& options, const Console& console) {
  JsonFindings json;
  bool is_good = true;
  for (const std::string& name : options.manifests) {
    const std::string file = resolve_input_file(name, console);
    const Findings findings = findings_in(file, options);
    json.add(file, findings);
    is_good = is_good && findings.faults.empty();
    if (!options.json) print_result(findings, file, console);
  }
  if (options.json) console.out << json.text() << '\n';
  return is_good ? exit_done : exit_bad_input;
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  return {
      .name = "check",
      .summary = "Check a manifest, or a file that it names, and list all faults",
      .options =
          {argument("manifest", &options->manifests,
                    "Manifests, or files of scales, of recipes or of a set (YAML)"),
           option("--out,-o", &options->out, "Output folder, as for mien run").with_default(),
           flag("--quick", &options->quick, "Check the files only; synthesize no motions"),
           flag("--thorough", &options->thorough,
                fmt::format("Synthesize all motions of a large study instead of a sample of {}",
                            most_rehearsed)),
           flag("--json", &options->json, "Faults, warnings and notes as JSON on standard output")},
      .notes =
          "If the manifest has no faults, its motions are synthesized and staged, but nothing is "
          "rendered or written. Faults are printed as file:line:column: path.to.key: what is "
          "wrong; how to fix it.\n\nExample:\n  mien check my.yaml",
      .run = [options](const Console& console) { return check(*options, console); }};
}

}  // namespace mien::pipeline
