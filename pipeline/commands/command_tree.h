#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mien::pipeline {

/// What may stand behind a command: an option (with names) or an argument (without).
struct CommandOption {
  std::vector<std::string> names;    ///< "-o", "--output"; empty for an argument
  std::string argument;              ///< "files"; empty for an option
  std::string value;                 ///< what it takes: "TEXT", "INT", …; empty for a flag
  std::vector<std::string> choices;  ///< all that it takes; empty when it takes other things
  std::string limits;                ///< "1 to 240"; empty when there are none
  std::string usual;                 ///< what it is when nobody says; empty when nothing is
  std::string help;
  bool required = false;
  bool repeats = false;  ///< takes several values

  bool takes_number() const { return value == "INT" || value == "UINT" || value == "FLOAT"; }
};

/// A command as `--help` shows it, as values.
struct CommandPage {
  std::string name;     ///< as it is typed: "mien study analyze"
  std::string summary;  ///< one line
  std::string notes;    ///< what stands below the options; its own, not its parent's
  std::vector<CommandOption> options;
  std::vector<CommandOption> arguments;
  std::vector<CommandPage> commands;
};

/// All of the program's commands: what `--help` is made of, for the manual page and for shells.
/// `-h, --help` itself, which every command takes, is left out.
CommandPage command_tree(const CLI::App& app);

/// "analyze" of "mien study analyze"
std::string last_word(const CommandPage& page);

/// The page and all below it, parents first.
std::vector<const CommandPage*> every_page(const CommandPage& page);

}  // namespace mien::pipeline
