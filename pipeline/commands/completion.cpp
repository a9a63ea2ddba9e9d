#include "pipeline/commands/completion.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "pipeline/commands/cli.h"

namespace mien::pipeline {

std::string command_that_lists(const CommandPage& page, const CommandOption& argument) {
  if (argument.argument == "manifest") return "mien manifests";
  return argument.argument == "name" ? page.name : "";
}

void add_completion_command(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("completion", "Print the script that lets a shell complete commands");
  const auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "For which shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  command->footer(
      "\nThe Debian package brings both. Without it:\n"
      "  source <(mien completion bash)     in ~/.bashrc\n"
      "  source <(mien completion zsh)      in ~/.zshrc, after compinit");
  command->callback([&app, &chosen, shell] {
    chosen = [&app, shell](const Console& console) {
      const CommandPage program = command_tree(app);
      console.out << (*shell == "bash" ? bash_completion(program) : zsh_completion(program));
      return exit_done;
    };
  });
}

}  // namespace mien::pipeline
