#include <algorithm>

#include <fmt/format.h>

#include "pipeline/commands/completion.h"

namespace mien::pipeline {

namespace {

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

/// ":what:action", the part of a specification that says what a value may be.
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
  std::string all;
  std::string marked;
  for (const std::string& name : option.names) {
    const std::string mark = !takes_value ? "" : name.starts_with("--") ? "=" : "+";
    all += (all.empty() ? "" : " ") + name;
    marked += (marked.empty() ? "" : ",") + name + mark;
  }
  const std::string told =
      "[" + zsh_text(option.help) + "]" + (takes_value ? zsh_value(page, option) : "");
  if (option.names.size() == 1) return "'" + marked + told + "'";
  return "'(" + all + ")'{" + marked + "}'" + told + "'";
}

std::string zsh_options(const CommandPage& page) {
  std::string lines = " \\\n    '(- *)'{-h,--help}'[Say what it takes]'";
  for (const CommandOption& option : page.command.named_options()) {
    lines += " \\\n    " + zsh_option(page, option);
  }
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
    names += "    'help:Say what a command takes'\n";
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

}  // namespace

std::string zsh_completion(const Command& program) {
  std::string script = zsh_head;
  for (const CommandPage& page : every_page(program)) {
    script += "\n" + zsh_function(page.name) + "() {\n";
    script += page.command.commands.empty()
                  ? "  _arguments -s" + zsh_options(page) + zsh_arguments(page) + "\n"
                  : zsh_group(program, page);
    script += "}\n";
  }
  return script + zsh_tail;
}

}  // namespace mien::pipeline
