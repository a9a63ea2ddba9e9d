#include "pipeline/commands/regress/regress.h"
#include "pipeline/regression/comparison/compared_media.h"

namespace mien::pipeline {

int regress_media_files(const RegressOptions& options, const Console& console) {
  const ComparedMedia media = compared_media(options.before, options.now, options.perceptual);
  if (options.json) {
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    console.out << as_json(media).dump(2, ' ', false, replace) << '\n';
  } else {
    console.out << as_text(media);
  }
  return media.are_alike() ? exit_done : exit_failed;
}

}  // namespace mien::pipeline
