#include "pipeline/commands/line/program.h"
#include "pipeline/commands/study/study.h"

int main(int argc, char** argv) {
  using namespace mien::pipeline;
  return run_program(argc, argv, [] { return program_of({studio_command(), study_command()}); });
}
