#pragma once

#include <string>
#include <vector>

#include "motion/interpolation/interpolation_options.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Methods of interpolation that take parameters; shares of the examples are an interface of their
/// own.
std::vector<motion::InterpolationMethod> methods_with_parameters();

/// The option --methods; `otherwise` says what happens without it.
CommandOption methods_option(std::vector<motion::InterpolationMethod>& methods,
                             const std::string& otherwise);

/// The manifest of that name, which must have a questionnaire. Throws Faults, or Error where it has
/// none.
Manifest asked_manifest(const std::string& name, const Console& console);

/// The manifest of that name, which must have a questionnaire or a matching experiment. Throws
/// likewise.
Manifest participants_manifest(const std::string& name, const Console& console);

inline constexpr char asked_manifest_help[] =
    "Manifest (YAML) with a questionnaire or a matching experiment, the name of one of mien "
    "manifests, or a study's "
    "provenance.json";

struct Console;

/// What a study command is about, as its options say it.
struct StudySubject {
  std::string examples;  ///< a manifest (.yaml), or what `parse_examples` takes
  std::string ratings;   ///< CSV; empty: the manifest's, or those of a built-in set
  std::string scales;    ///< YAML; empty: the manifest's, or the built-in pairs
};

/// The manifest with what the options say over it, or one of the options alone. A manifest that is
/// not there is looked for among the installed ones. Throws Error.
Manifest manifest_of(const StudySubject& subject, const Console& console);

/// The options --examples (required), --ratings and --scales, which say what a command is about.
std::vector<CommandOption> subject_options(StudySubject& subject);

Command studio_command();
Command study_command();

// Subcommands of `mien study`, one a source file.
Command study_analyze_command();
Command study_design_command();
Command study_evaluate_command();
Command study_export_command();
Command study_features_command();
Command study_interfaces_command();
Command study_methods_command();
Command study_predict_command();
Command study_serve_command();
Command study_report_command();
Command study_simulate_command();
Command study_targets_command();
Command study_words_command();

}  // namespace mien::pipeline
