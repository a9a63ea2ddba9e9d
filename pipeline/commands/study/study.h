#pragma once

#include <string>
#include <vector>

#include "motion/interpolation/interpolation_options.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The interpolation methods that have parameters: all except direct blend weights.
std::vector<motion::InterpolationMethod> methods_with_parameters();

/// The option --methods; `otherwise` describes the default.
CommandOption methods_option(std::vector<motion::InterpolationMethod>& methods,
                             const std::string& otherwise);

/// Reads the manifest of that name, which must have a questionnaire. Throws Faults, or Error if it
/// has none.
Manifest questionnaire_manifest(const std::string& name, const Console& console);

/// Reads the manifest of that name, which must have a questionnaire or a matching or adaptive
/// experiment. Throws Faults, or Error if it has none.
Manifest participants_manifest(const std::string& name, const Console& console);

inline constexpr char study_manifest_help[] =
    "Manifest (YAML) with a questionnaire or an experiment, the name of an installed "
    "manifest (listed by mien manifests), or a study's provenance.json";

struct Console;

/// The examples, ratings and scales of a study command, from its options.
struct StudySubject {
  std::string examples;          ///< a manifest (.yaml, .yml), or the syntax of `parse_examples`
  std::string ratings;           ///< CSV; empty: the manifest's, or those of a built-in set
  std::string scales;            ///< YAML; empty: the manifest's, or the built-in pairs
  RecordingArguments recording;  ///< how the files of a folder are read
};

/// The named manifest with the options applied, or a manifest built from the options alone. If the
/// named file does not exist, an installed manifest of that name is used. Throws Error.
Manifest manifest_of(const StudySubject& subject, const Console& console);

/// The options --examples (required), --ratings and --scales, and those of `recording_options` if
/// the command has no other motion files.
std::vector<CommandOption> subject_options(StudySubject& subject);
std::vector<CommandOption> subject_and_recording_options(StudySubject& subject);

Command studio_command();
Command study_command();

// Subcommands of `mien study`, one per source file.
Command study_analyze_command();
Command study_chains_command();
Command study_design_command();
Command study_estimate_command();
Command study_evaluate_command();
Command study_export_command();
Command study_features_command();
Command study_interfaces_command();
Command study_methods_command();
Command study_next_command();
Command study_predict_command();
Command study_recipes_command();
Command study_serve_command();
Command study_report_command();
Command study_simulate_command();
Command study_targets_command();
Command study_withdraw_command();
Command study_words_command();

}  // namespace mien::pipeline
