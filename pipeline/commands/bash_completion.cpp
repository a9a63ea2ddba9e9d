#include <fmt/format.h>

#include "pipeline/commands/completion.h"

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

std::string joined_words(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

/// Every path to a command, which is how the script knows where it is.
std::string bash_commands(const Command& program) {
  std::vector<std::string> names;
  for (const CommandPage& page : every_page(program)) {
    if (&page.command != &program) names.push_back("'" + page.name + "'");
  }
  return "      " + joined_words(names, " | \\\n        ") +
         ")\n        command+=\" ${COMP_WORDS[i]}\" ;;\n    esac\n  done\n";
}

/// What to do about a value: offer its choices, files, or nothing (numbers).
std::string bash_value(const CommandOption& option) {
  if (!option.choices.empty()) return "words='" + joined_words(option.choices, " ") + "'";
  return option.takes_number() ? "return 0" : "files=1";
}

/// Cases of `"$command $before"`: options that take a value.
std::string bash_values(const Command& program) {
  std::string cases;
  for (const CommandPage& page : every_page(program)) {
    for (const CommandOption& option : page.command.named_options()) {
      if (option.value.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) {
        patterns.push_back("'" + page.name + " " + name + "'");
      }
      cases += fmt::format("    {}) {} ;;\n", joined_words(patterns, " | "), bash_value(option));
    }
  }
  return cases;
}

std::string bash_options(const CommandPage& page) {
  std::string names = "-h --help";
  for (const CommandOption& option : page.command.named_options()) {
    names += " " + joined_words(option.names, " ");
  }
  return names;
}

/// What may stand where no option does.
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

}  // namespace

std::string bash_completion(const Command& program) {
  std::string script = bash_head + bash_commands(program);
  script += "  case \"$command $before\" in\n" + bash_values(program);
  script += "    *)\n      if [[ $word == -* ]]; then\n        case $command in\n";
  for (const CommandPage& page : every_page(program)) {
    script += fmt::format("          '{}') words='{}' ;;\n", page.name, bash_options(page));
  }
  script += "        esac\n      else\n        case $command in\n";
  for (const CommandPage& page : every_page(program)) {
    script += fmt::format("          '{}') {} ;;\n", page.name, bash_arguments(program, page));
  }
  return script + "        esac\n      fi ;;\n  esac" + bash_tail;
}

}  // namespace mien::pipeline
