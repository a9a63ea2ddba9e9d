#include "pipeline/commands/completion.h"

#include <memory>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/other_programs.h"
#include "pipeline/commands/programs.h"

namespace mien::pipeline {

std::string command_that_lists(const CommandPage& page, const CommandOption& argument) {
  if (argument.argument == "manifest") return "mien manifests";
  return argument.argument == "name" ? page.name : "";
}

Command completion_command() {
  const auto shell = std::make_shared<std::string>();
  return {.name = "completion",
          .summary = "Print the script that lets a shell complete commands",
          .options = {argument("shell", shell.get(), "For which shell").one_of({"bash", "zsh"})},
          .notes =
              "The Debian package brings both. Without it:\n"
              "  source <(mien completion bash)     in ~/.bashrc\n"
              "  source <(mien completion zsh)      in ~/.zshrc, after compinit",
          .run = [shell](const Console& console) {
            console.out << (*shell == "bash" ? bash_completion
                                             : zsh_completion)(with_other_programs(mien_program()));
            return exit_done;
          }};
}

}  // namespace mien::pipeline
