#include "pipeline/commands/line/examples_option.h"

#include "motion/error.h"
#include "motion/formats/motion_file.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/reading/example_source.h"

namespace mien::pipeline {

Examples examples_of(const std::string& examples, const RecordingArguments& arguments) {
  Examples result = parse_examples(examples);
  if (!result.builtin.empty())
    refuse_recording_options(arguments, "a built-in set", "omit them, or name a folder");
  result.how = recording_choice(arguments);
  if (!result.how.take.empty() && !may_hold_takes(result))
    throw Error("--take: none of the files can hold several motions",
                "omit it; only " + motion::formats_with_takes() + " can hold several");
  return result;
}

void refuse_recording_options(const RecordingArguments& arguments, const std::string& what,
                              const std::string& remedy) {
  if (!arguments.are_given()) return;
  throw Error(
      "--take, --subject, --recorded-fps, --joints and --body-model apply to motion files, not "
      "to " +
          what,
      remedy);
}

}  // namespace mien::pipeline
