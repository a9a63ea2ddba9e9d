#include <algorithm>
#include <memory>
#include <string>

#include <fmt/ranges.h>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/programs.h"

namespace mien::pipeline {

namespace {

constexpr char bash_head[] = R"(# bash completion for mien, as `mien completion bash` prints it
_mien() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  local command=mien words='' files='' i
  COMPREPLY=()
  if [[ $word == '=' ]]; then
    word=''
  elif [[ $before == '=' ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
)";

constexpr char bash_tail[] = R"(
  [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  if [[ -n $files ]]; then
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$word")
    compopt -o filenames 2>/dev/null
  fi
  return 0
}
complete -F _mien mien
)";

/// The command whose first output column lists an argument's values: "mien sets" for the name of a
/// set. Empty if there is none.
std::string command_that_lists(const CommandPage& page, const CommandOption& argument) {
  if (argument.argument == "manifest") return "mien manifests";
  return argument.argument == "name" ? page.name : "";
}

std::string joined_words(const std::vector<std::string>& words, const std::string& separator) {
  return fmt::to_string(fmt::join(words, separator));
}

/// All command paths, by which the script recognises the current command.
std::string bash_commands(const Command& program) {
  std::vector<std::string> names;
  for (const CommandPage& page : all_command_pages(program))
    if (&page.command != &program) names.push_back("'" + page.name + "'");
  return "      " + joined_words(names, " | \\\n        ") +
         ")\n        command+=\" ${COMP_WORDS[i]}\" ;;\n    esac\n  done\n";
}

/// Shell code that completes a value: its choices, files, or nothing (numbers).
std::string bash_value(const CommandOption& option) {
  if (!option.choices.empty()) return "words='" + joined_words(option.choices, " ") + "'";
  return option.takes_number() ? "return 0" : "files=1";
}

/// Cases of `"$command $before"`: options that take a value.
std::string bash_values(const Command& program) {
  std::string cases;
  for (const CommandPage& page : all_command_pages(program)) {
    for (const CommandOption& option : page.command.named_options()) {
      if (option.value.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names)
        patterns.push_back("'" + page.name + " " + name + "'");
      cases += fmt::format("    {}) {} ;;\n", joined_words(patterns, " | "), bash_value(option));
    }
  }
  return cases;
}

std::string bash_options(const CommandPage& page) {
  std::string names = "-h --help";
  for (const CommandOption& option : page.command.named_options())
    names += " " + joined_words(option.names, " ");
  return names;
}

/// Completions in places where no option is expected.
std::string bash_arguments(const Command& program, const CommandPage& page) {
  if (!page.command.commands.empty()) {
    std::vector<std::string> names;
    for (const Command& command : page.command.commands) names.push_back(command.name);
    if (&page.command == &program) names.emplace_back("help");
    return "words='" + joined_words(names, " ") + "'";
  }
  const std::vector<CommandOption> arguments = page.command.arguments();
  if (arguments.empty()) return ":";
  const CommandOption& first = arguments.front();
  if (const std::string list = command_that_lists(page, first); !list.empty()) {
    const bool takes_files = first.argument == "manifest";
    return fmt::format("words=$({} 2>/dev/null | cut -d' ' -f1){}", list,
                       takes_files ? " files=1" : "");
  }
  return bash_value(first);
}

constexpr char zsh_head[] = R"(#compdef mien
# zsh completion for mien, as `mien completion zsh` prints it
)";

constexpr char zsh_tail[] = R"(
# Loaded by compinit as a function, or read by source.
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
  _mien "$@"
else
  compdef _mien mien
fi
)";

/// "mien study analyze" as "_mien_study_analyze".
std::string zsh_function(const std::string& command) {
  std::string name = "_" + command;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// Text within single quotes, in which _arguments gives these characters a meaning.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result;
}

std::string zsh_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + zsh_text(word);
  return text;
}

/// ":what:action", the part of a specification that describes a value.
std::string zsh_value(const CommandPage& page, const CommandOption& option) {
  const std::string what = option.argument.empty() ? option.value : option.argument;
  const std::string start = ":" + zsh_text(what) + ":";
  if (!option.choices.empty()) return start + "(" + zsh_words(option.choices) + ")";
  if (const std::string list = command_that_lists(page, option); !list.empty()) {
    const std::string words = "($(" + list + " 2>/dev/null | cut -d\" \" -f1))";
    if (option.argument != "manifest") return start + words;
    return start + "{ compadd -- $(" + list + " 2>/dev/null | cut -d\" \" -f1); _files }";
  }
  return start + (option.takes_number() ? " " : "_files");
}

/// One line of _arguments for an option: '(-o --out)'{-o+,--out=}'[help]:TEXT:_files'.
std::string zsh_option(const CommandPage& page, const CommandOption& option) {
  const bool takes_value = !option.value.empty();
  std::string marked;
  for (const std::string& name : option.names) {
    const std::string mark = !takes_value ? "" : name.starts_with("--") ? "=" : "+";
    marked += (marked.empty() ? "" : ",") + name + mark;
  }
  const std::string description =
      "[" + zsh_text(option.help) + "]" + (takes_value ? zsh_value(page, option) : "");
  if (option.names.size() == 1) return "'" + marked + description + "'";
  return "'(" + joined_words(option.names, " ") + ")'{" + marked + "}'" + description + "'";
}

std::string zsh_options(const CommandPage& page) {
  std::string lines = " \\\n    '(- *)'{-h,--help}'[Show help]'";
  for (const CommandOption& option : page.command.named_options())
    lines += " \\\n    " + zsh_option(page, option);
  return lines;
}

std::string zsh_arguments(const CommandPage& page) {
  std::string lines;
  for (const CommandOption& argument : page.command.arguments()) {
    const std::string place = argument.repeats ? "*" : argument.is_required ? "" : ":";
    lines += " \\\n    '" + place + zsh_value(page, argument) + "'";
  }
  return lines;
}

/// A command with commands below it: completes their names, then hands over to theirs.
std::string zsh_group(const Command& program, const CommandPage& page) {
  std::string names;
  std::string calls;
  for (const Command& command : page.command.commands) {
    names += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.summary));
    calls += fmt::format("        {}) {} ;;\n", command.name,
                         zsh_function(page.name + " " + command.name));
  }
  if (&page.command == &program) {
    names += "    'help:Show help for a command'\n";
    calls += "        help) " + zsh_function(program.name) + " ;;\n";
  }
  return fmt::format(
      "  local curcontext=\"$curcontext\" state line\n  typeset -A opt_args\n"
      "  local -a commands\n  commands=(\n{}  )\n"
      "  _arguments -C{} \\\n    '1: :->command' '*:: :->arguments'\n"
      "  case $state in\n    command) _describe -t commands 'command' commands ;;\n"
      "    arguments)\n      case $line[1] in\n{}      esac ;;\n  esac\n",
      names, zsh_options(page), calls);
}

/// Scripts that let a shell complete commands, options, values of options with fixed choices,
/// names of manifests and sets, and files.
std::string bash_completion(const Command& program) {
  std::string script = bash_head + bash_commands(program);
  script += "  case \"$command $before\" in\n" + bash_values(program);
  script += "    *)\n      if [[ $word == -* ]]; then\n        case $command in\n";
  for (const CommandPage& page : all_command_pages(program))
    script += fmt::format("          '{}') words='{}' ;;\n", page.name, bash_options(page));
  script += "        esac\n      else\n        case $command in\n";
  for (const CommandPage& page : all_command_pages(program))
    script += fmt::format("          '{}') {} ;;\n", page.name, bash_arguments(program, page));
  return script + "        esac\n      fi ;;\n  esac" + bash_tail;
}

std::string zsh_completion(const Command& program) {
  std::string script = zsh_head;
  for (const CommandPage& page : all_command_pages(program)) {
    script += "\n" + zsh_function(page.name) + "() {\n";
    script += page.command.commands.empty()
                  ? "  _arguments -s" + zsh_options(page) + zsh_arguments(page) + "\n"
                  : zsh_group(program, page);
    script += "}\n";
  }
  return script + zsh_tail;
}

}  // namespace

Command completion_command() {
  const auto shell = std::make_shared<std::string>();
  return {.name = "completion",
          .summary = "Print the shell completion script",
          .options = {argument("shell", shell.get(), "Shell").one_of({"bash", "zsh"})},
          .notes =
              "The Debian package installs the scripts for both shells. Without the package, add:\n"
              "  source <(mien completion bash)     in ~/.bashrc\n"
              "  source <(mien completion zsh)      in ~/.zshrc, after compinit",
          .run = [shell](const Console& console) {
            console.out << (*shell == "bash" ? bash_completion : zsh_completion)(
                with_external_programs(mien_program()));
            return exit_done;
          }};
}

}  // namespace mien::pipeline
