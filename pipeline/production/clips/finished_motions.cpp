#include "pipeline/production/clips/finished_motions.h"

#include "motion/skeleton/straighten.h"

namespace mien::pipeline {

motion::Clip playback_clip(const motion::Clip& motion, const Output& output) {
  return motion::playback_clip(motion, {output.cycles, output.in_place});
}

}  // namespace mien::pipeline
