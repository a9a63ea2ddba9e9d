#include "pipeline/commands/line/other_programs.h"
#include "pipeline/commands/line/program.h"
#include "pipeline/commands/programs.h"
#include "pipeline/production/archive/tar_archive.h"

namespace mien::pipeline {

Command mien_program() {
  return program_of({run_command(), check_command(), plan_command(), verify_command(),
                     command_elsewhere(regress_program), clean_command(), pack_command(),
                     render_command(), motion_command(), manifests_command(), sets_command(),
                     command_elsewhere(studio_program), command_elsewhere(study_program),
                     farm_command(),
                     version_command("Show the versions of mien and its libraries",
                                     {{"libarchive", archive_library()}}),
                     completion_command(), man_command()});
}

}  // namespace mien::pipeline
