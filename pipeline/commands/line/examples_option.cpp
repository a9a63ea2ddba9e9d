#include "pipeline/commands/line/examples_option.h"

#include "motion/error.h"
#include "pipeline/manifest/reading/example_source.h"

namespace mien::pipeline {

Examples examples_of(const std::string& examples, const RecordingArguments& arguments) {
  Examples result = parse_examples(examples);
  if (!result.builtin.empty())
    refuse_recording_options(arguments, "a built-in set", "omit them, or name a folder");
  result.how = recording_choice(arguments);
  return result;
}

void refuse_recording_options(const RecordingArguments& arguments, const std::string& what,
                              const std::string& remedy) {
  if (!arguments.are_given()) return;
  throw Error(
      "--take, --subject, --recorded-fps and --joints apply to motion files, not to " + what,
      remedy);
}

}  // namespace mien::pipeline
