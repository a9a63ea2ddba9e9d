#include "pipeline/commands/line/program.h"
#include "pipeline/commands/programs.h"

int main(int argc, char** argv) {
  return mien::pipeline::run_program(argc, argv, mien::pipeline::mien_program);
}
