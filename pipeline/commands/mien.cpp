#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/line/program.h"
#include "pipeline/commands/programs.h"
#include "pipeline/production/archive/tar_archive.h"

namespace mien::pipeline {

Command mien_program() {
  return program_of({run_command(), check_command(), plan_command(), verify_command(),
                     external_command(regress_program), clean_command(), pack_command(),
                     render_command(), motion_command(), manifests_command(), sets_command(),
                     external_command(studio_program), external_command(study_program),
                     farm_command(),
                     version_command("Show the versions of mien and its libraries",
                                     {{"libarchive", archive_library()}}),
                     completion_command(), man_command()});
}

}  // namespace mien::pipeline
