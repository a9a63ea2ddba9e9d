#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include "motion/error.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/commands/line/command_line_fault.h"
#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/line/program.h"
#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

/// Adds an option to what CLI11 parses, by the variable that it sets.
struct AddedOption {
  CLI::App& app;
  const CommandOption& option;
  std::string names = fmt::to_string(fmt::join(option.names, ","));

  CLI::Option* operator()(std::monostate) const {
    return app.set_version_flag(names, "mien " + std::string(program_version()));
  }
  CLI::Option* operator()(bool* variable) const {
    return app.add_flag(names, *variable, option.help);
  }
  CLI::Option* operator()(const std::function<void(const std::string&)>& take) const {
    using Texts = std::vector<std::string>;
    if (option.value.empty())
      return app.add_flag_callback(
          names, [take] { take("true"); }, option.help);
    if (!option.repeats) return app.add_option_function<std::string>(names, take, option.help);
    return app.add_option_function<Texts>(
        names, [take](const Texts& texts) { std::ranges::for_each(texts, take); }, option.help);
  }
  template <class Value>
  CLI::Option* operator()(Value* variable) const {
    return app.add_option(option.is_argument() ? option.argument : names, *variable, option.help);
  }
};

/// Whether a value is a number within an option's limits, and an integer if required.
bool is_allowed(const std::string& given, const CommandOption& option) {
  const std::optional<double> number = motion::as_written_number(given);
  if (!number || (option.value != "FLOAT" && *number != std::trunc(*number))) return false;
  return std::isinf(option.largest) ? *number > option.least
                                    : *number >= option.least && *number <= option.largest;
}

/// Prints "files..." for an argument that takes several values, whatever CLI11's version.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_usage(const CLI::Option* option) const override {
    if (option->get_expected_max() <= 1) return CLI::Formatter::make_option_usage(option);
    const std::string usage = make_option_name(option, true) + "...";
    return option->get_required() ? usage : "[" + usage + "]";
  }
};

/// Checks the limits of an option with a message of its own, since those of CLI11 depend on its
/// version.
CLI::Validator limits_of(const CommandOption& option) {
  const bool is_bounded = !std::isinf(option.largest);
  const std::string allowed = fmt::format(
      "{} {}", option.value == "FLOAT" ? "a number" : "a whole number",
      is_bounded ? "from " + option.limits : fmt::format("above {:.10g}", option.least));
  const std::string in_help = is_bounded ? fmt::format("{} in [{:.10g} - {:.10g}]", option.value,
                                                       option.least, option.largest)
                                         : "POSITIVE";
  return {[option, allowed](const std::string& given) {
            return is_allowed(given, option) ? "" : motion::excerpt(given) + " is not " + allowed;
          },
          in_help};
}

/// Refuses an empty value, as from an unset shell variable, which never means omitting the option.
std::string fault_of_empty(const std::string& given) {
  return given.empty() ? "empty; give a value, or omit it" : "";
}

/// Understands the old name of an option: its values are the option's, and so are their faults.
void add_former_name(CLI::App& app, const CommandOption& option, CLI::Option* now,
                     std::ostream& err) {
  const std::string name = option.names.back();
  CLI::callback_t pass_on = [former = option.former, name, now,
                             &err](const CLI::results_t& values) {
    if (now->count() > 0)
      throw CLI::ValidationError(former, "now called " + name + ", which is given too; omit it");
    err << "warning: " << former << " is now called " << name << '\n';
    now->add_result(values);
    now->run_callback();
    return true;
  };
  app.add_option(option.former, std::move(pass_on))
      ->expected(now->get_expected_min(), now->get_expected_max())
      ->allow_extra_args(now->get_allow_extra_args())
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->default_str("true")  // of a flag
      ->group("");           // hidden
}

void add_option(CLI::App& app, const CommandOption& option, std::ostream& err) {
  CLI::Option* added = std::visit(AddedOption{app, option}, option.variable);
  if (option.is_required) added->required();
  if (option.has_commas) added->delimiter(',');
  if (option.value_count) added->expected(option.value_count->first, option.value_count->second);
  if (option.value_count == std::pair(1, 1))
    added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  if (!option.limits.empty()) added->check(limits_of(option));
  if (option.fault) {
    added->check(option.fault)->type_name(option.value);
  } else if (!option.choices.empty()) {
    added->check(CLI::IsMember(option.choices));
  }
  if (!option.value.empty()) added->check(fault_of_empty);
  if (!option.usual.empty()) added->default_str(option.usual);
  if (!option.group.empty()) added->group(option.group);
  if (!option.former.empty()) add_former_name(app, option, added, err);
}

/// Translates a command for CLI11, which parses and prints --help. Warns of former names on `err`.
void fill(CLI::App& app, const Command& command, std::ostream& err) {
  if (!command.notes.empty()) app.footer("\n" + command.notes);
  for (const CommandOption& option : command.options) add_option(app, option, err);
  for (const CommandOption& option : command.options) {
    if (!option.excluded.empty())
      app.get_option(option.names.back())->excludes(app.get_option(option.excluded));
    if (!option.needed.empty())
      app.get_option(option.names.back())->needs(app.get_option(option.needed));
  }
  // One at most: the word after it is its own, whatever it is (mien sets studio).
  if (!command.commands.empty()) app.require_subcommand(command.run ? 0 : 1, 1);
  for (const Command& below : command.commands)
    fill(*app.add_subcommand(below.name, below.summary), below, err);
}

/// The command that was typed. Adds the names of its used options to their `given` lists.
const Command& typed_command(const CLI::App& app, const Command& command) {
  if (!app.get_subcommands().empty()) {
    const CLI::App& below = *app.get_subcommands().front();
    return typed_command(below, *subcommand_named(command, below.get_name()));
  }
  for (const CommandOption& option : command.options)
    if (option.given != nullptr && app.get_option(option.names.back())->count() > 0)
      option.given->push_back(option.names.back());
  return command;
}

/// The command lines that end with this word: "mien study export", "mien farm export".
void find_lines(const Command& command, const std::string& line, const std::string& word,
                std::vector<std::string>& found) {
  for (const Command& below : command.commands) {
    const std::string here = line + " " + below.name;
    if (below.name == word) found.push_back(here);
    find_lines(below, here, word, found);
  }
}

/// A question about commands of this name elsewhere; empty if there are none.
std::string did_you_mean_elsewhere(const Command& program, const std::string& word) {
  std::vector<std::string> found;
  find_lines(with_other_programs(program), program.name, word, found);
  return found.empty() ? "" : fmt::format("did you mean {}?", fmt::join(found, ", or "));
}

/// A sentence about the first unknown command; empty if all are known.
std::string unknown_command(const Command& program, const std::vector<std::string>& words) {
  const Command* at = &program;
  for (const std::string& word : words) {
    if (at->commands.empty() || word.starts_with('-')) return "";
    const Command* below = subcommand_named(*at, word);
    if (below == nullptr && !at->arguments().empty()) return "";
    if (below == nullptr) {
      std::vector<std::string> known;
      for (const Command& command : at->commands) known.push_back(command.name);
      const std::string elsewhere = did_you_mean_elsewhere(program, word);
      return "unknown command " + motion::in_quotes(word) + "; " +
             (elsewhere.empty() ? motion::did_you_mean(word, known) : elsewhere);
    }
    at = below;
  }
  return "";
}

/// `mien help render` means `mien render --help`.
std::vector<std::string> arguments_of(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return words;
}

/// Parses the words. Returns an exit code if help was shown or a fault was reported.
std::optional<int> parse(CLI::App& app, const Command& program, std::vector<std::string> words,
                         const Console& console) {
  if (words.empty()) {
    console.err << app.help();
    return exit_bad_input;
  }
  if (const std::string fault = unknown_command(program, words); !fault.empty()) {
    console.err << fault << '\n';
    return exit_bad_input;
  }
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  try {
    app.parse(std::move(words));
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error, console.out, console.err);
    console.err << command_line_fault(app, error) << '\n';
    return exit_bad_input;
  }
}

int perform(const Command& command, const Console& console) {
  try {
    return command.run(console);
  } catch (const Interrupted&) {
    console.err << "interrupted\n";
    return exit_interrupted;
  } catch (const Error& error) {
    console.err << error.what() << '\n';
    return exit_bad_input;
  } catch (const std::exception& error) {
    console.err << "mien: " << failure_text(error) << '\n';
    return exit_failed;
  }
}

}  // namespace

int run_command_line(const Command& program, int argc, const char* const* argv,
                     const Console& console) {
  if (argc == 2 && std::string_view(argv[1]) == "--commands") {
    console.out << program_as_json(program) << '\n';
    return exit_done;
  }
  CLI::App app(program.summary, program.name);
  app.formatter(std::make_shared<HelpFormatter>());
  fill(app, program, console.err);
  const std::optional<int> code = parse(app, program, arguments_of(argc, argv), console);
  return code ? *code : perform(typed_command(app, program), console);
}

}  // namespace mien::pipeline
