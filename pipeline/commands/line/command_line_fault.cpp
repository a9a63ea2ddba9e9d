#include "pipeline/commands/line/command_line_fault.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"

namespace mien::pipeline {

namespace {

/// The innermost command that was typed.
const CLI::App& innermost_command(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

/// "mien study export"
std::string name_with_parents(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name()
                           : name_with_parents(*parent) + " " + command.get_name();
}

/// "--output", or "manifest" for a positional argument.
std::string name_of_option(const CLI::Option& option) {
  const std::vector<std::string>& names = option.get_lnames();
  if (!names.empty()) return "--" + names.front();
  return option.get_positional() ? option.get_name(true) : option.get_name();
}

std::vector<const CLI::Option*> required_options(const CLI::App& command) {
  std::vector<const CLI::Option*> required;
  for (const CLI::Option* option : command.get_options())
    if (option->get_required()) required.push_back(option);
  return required;
}

/// "mien study export <manifest> --output …": the minimal command line.
std::string least_line(const CLI::App& command) {
  std::string words, flags;
  for (const CLI::Option* option : required_options(command)) {
    const std::string name = name_of_option(*option);
    (name.starts_with("--") ? flags : words) +=
        name.starts_with("--") ? fmt::format(" {} …", name) : fmt::format(" <{}>", name);
  }
  return name_with_parents(command) + words + flags;
}

std::string help_line(const CLI::App& command) {
  return "see " + name_with_parents(command) + " --help";
}

/// Required options and arguments that are missing.
std::vector<std::string> missing_names(const CLI::App& command) {
  std::vector<std::string> missing;
  for (const CLI::Option* option : required_options(command))
    if (option->count() == 0) missing.push_back(name_of_option(*option));
  return missing;
}

std::string missing_fault(const CLI::App& command, const std::vector<std::string>& missing) {
  return fmt::format("{} {} missing; write {}; {}", fmt::join(missing, " and "),
                     missing.size() == 1 ? "is" : "are", least_line(command), help_line(command));
}

/// Short and long flags of a command, those of --help.
std::vector<std::string> flags_of(const CLI::App& command) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    for (const std::string& name : option->get_snames()) flags.push_back("-" + name);
  }
  return flags;
}

bool is_flag(const std::string& word) {
  return word.size() > 1 && word.front() == '-' &&
         std::isdigit(static_cast<unsigned char>(word[1])) == 0;
}

std::string unknown_flag_fault(const CLI::App& command, const std::string& given) {
  const std::string flag = given.substr(0, given.find('='));
  const auto near = motion::nearest_word(flag, flags_of(command));
  return fmt::format("unknown option {}; {}{}", flag,
                     near ? fmt::format("did you mean {}? ", *near) : "", help_line(command));
}

/// The message of CLI11 for an invalid value.
std::string parser_fault(const CLI::App& command, const CLI::ParseError& fault) {
  std::string wrong = fault.what();
  const std::size_t end = wrong.find_last_not_of(" \n");
  wrong.erase(end == std::string::npos ? 0 : end + 1);
  std::ranges::replace(wrong, '\n', ' ');
  return wrong + (wrong.ends_with('?') ? " " : "; ") + help_line(command);
}

/// Replacement for "--jobs: 1 required INT missing" of CLI11; empty for other faults.
std::string valueless_fault(const CLI::App& command, const CLI::ParseError& fault) {
  const std::string wrong = fault.what();
  if (fault.get_name() != "ArgumentMismatch" || !wrong.ends_with(" missing")) return "";
  const std::string name = wrong.substr(0, wrong.find(':'));  // none of a former name
  return fmt::format("{}value missing; {}", name.empty() ? "" : name + ": ", help_line(command));
}

std::string no_command_fault(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* one : command.get_subcommands(nullptr)) names.push_back(one->get_name());
  return fmt::format("a command is missing; it is one of {}; {}", fmt::join(names, ", "),
                     help_line(command));
}

std::string fault_text(const CLI::App& command, const std::vector<std::string>& extras,
                       const CLI::ParseError& fault) {
  const auto flag = std::ranges::find_if(extras, is_flag);
  if (flag != extras.end()) return unknown_flag_fault(command, *flag);
  if (fault.get_name() == "RequiredError") {
    const std::vector<std::string> missing = missing_names(command);
    if (!missing.empty()) return missing_fault(command, missing);
    const bool takes_commands = !command.get_subcommands(nullptr).empty();
    if (takes_commands && command.get_require_subcommand_min() > 0)
      return no_command_fault(command);
  }
  if (fault.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !extras.empty())
    return fmt::format("unexpected argument {}; {}", motion::in_quotes(extras.front()),
                       help_line(command));
  const std::string fault_text = valueless_fault(command, fault);
  return fault_text.empty() ? parser_fault(command, fault) : fault_text;
}

}  // namespace

std::string command_line_fault(const CLI::App& app, const CLI::ParseError& fault) {
  const CLI::App& command = innermost_command(app);
  return name_with_parents(command) + ": " + fault_text(command, app.remaining(true), fault);
}

}  // namespace mien::pipeline
