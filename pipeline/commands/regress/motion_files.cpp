#include "pipeline/commands/line/take_option.h"
#include "pipeline/commands/regress/regress.h"
#include "pipeline/regression/comparison/compared_motions.h"

namespace mien::pipeline {

int regress_motion_files(const RegressOptions& options, const Console& console) {
  const ComparedMotions motions =
      compared_motion_files(options.before, options.now, options.tolerance,
                            takes_of(options.takes, {options.before, options.now}));
  if (options.json) {
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    console.out << as_json(motions).dump(2, ' ', false, replace) << '\n';
  } else {
    console.out << as_text(motions);
  }
  return motions.are_alike() ? exit_done : exit_failed;
}

}  // namespace mien::pipeline
