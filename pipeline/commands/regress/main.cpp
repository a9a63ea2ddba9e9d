#include "pipeline/commands/line/program.h"
#include "pipeline/commands/regress/regress.h"

int main(int argc, char** argv) {
  using namespace mien::pipeline;
  return run_program(argc, argv, [] { return program_of({regress_command()}); });
}
