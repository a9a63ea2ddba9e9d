#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mien::pipeline {

struct Console;

/// The target of an option: a variable, or a function that is called with the text of each value
/// ("true" for a flag). The variable must outlive the command. Empty for --version, and if the
/// command is implemented by another program (external_programs.h).
using BoundVariable =
    std::variant<std::monostate, bool*, int*, double*, std::uint64_t*, std::string*,
                 std::optional<int>*, std::optional<double>*, std::optional<std::uint64_t>*,
                 std::optional<std::string>*, std::vector<double>*, std::vector<std::string>*,
                 std::function<void(const std::string&)>>;

/// A parameter of a command: an option or flag, which has names, or a positional argument, which
/// has none.
struct CommandOption {
  std::vector<std::string> names;  ///< "-o", "--output"; empty for an argument
  std::string former;              ///< deprecated name: accepted with a warning, not listed in help
  std::string argument;            ///< name of an argument: "files"; empty for an option
  std::string value;               ///< type of its value: "TEXT", "INT", …; empty for a flag
  std::vector<std::string> choices;  ///< permitted values; empty if there is no list
  std::string limits;                ///< limits as text: "1 to 240"; empty if there are none
  std::string usual;                 ///< default value; empty if there is none
  std::string help;
  bool is_required = false;
  bool repeats = false;  ///< takes several values

  BoundVariable variable;
  // `least` and `largest` are checked only if `limits` is not empty.
  double least = 0.0;  ///< lower limit, exclusive if `largest` is infinite
  double largest = std::numeric_limits<double>::infinity();  ///< upper limit, inclusive
  std::optional<std::pair<int, int>> value_count;            ///< number of values per use
  bool has_commas = false;                                   ///< values are separated by commas
  std::string excluded;  ///< option that must not be used together with this one
  std::string needed;    ///< option that this one requires
  std::string group;     ///< heading in --help
  std::function<std::string(const std::string&)>
      fault;  ///< returns why a value is invalid, or empty
  std::vector<std::string>* given =
      nullptr;  ///< where to append the option's name when it is used; may be null

  bool is_argument() const { return names.empty(); }
  bool takes_number() const { return value == "INT" || value == "UINT" || value == "FLOAT"; }

  // Each returns a copy of the option with a changed property.
  CommandOption required() const;
  CommandOption optional() const;
  CommandOption one_of(std::vector<std::string> words) const;
  CommandOption between(double low, double high) const;
  CommandOption positive() const;
  CommandOption with_default() const;  ///< states the variable's current value as the default
  CommandOption with_default(std::string text) const;
  CommandOption with_commas() const;
  CommandOption values(int fewest, int most) const;
  CommandOption excludes(std::string option) const;
  CommandOption needs(std::string option) const;
  CommandOption in_group(std::string heading) const;
  CommandOption formerly(std::string name) const;  ///< sets the deprecated name
};

/// `names`: "--out,-o".
CommandOption option(const std::string& names, BoundVariable variable, std::string help);
CommandOption flag(const std::string& names, BoundVariable variable, std::string help);

/// A required positional argument.
CommandOption argument(std::string name, BoundVariable variable, std::string help);

/// An option whose value is one of `words`. `take` is called with the index of the word. For
/// another value, the error message suggests the most similar word or, if none is similar, lists
/// the words.
CommandOption choice_of(const std::string& names, std::vector<std::string> words, std::string help,
                        std::function<void(std::size_t)> take);

template <class Value>
using WordValues = std::vector<std::pair<std::string, Value>>;

template <class Value>
std::vector<std::string> names_of(const WordValues<Value>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

/// An option whose value is one of several words, each of which stands for a value.
template <class Value>
CommandOption choice(const std::string& names, Value& variable, const WordValues<Value>& values,
                     std::string help) {
  CommandOption made =
      choice_of(names, names_of(values), std::move(help),
                [&variable, values](std::size_t i) { variable = values[i].second; });
  for (const auto& [name, value] : values)
    if (value == variable) made.usual = name;
  return made;
}

/// An option with a comma-separated list of words, each of which stands for a value.
template <class Value>
CommandOption choice(const std::string& names, std::vector<Value>& variable,
                     const WordValues<Value>& values, std::string help) {
  CommandOption made =
      choice_of(names, names_of(values), std::move(help),
                [&variable, values](std::size_t i) { variable.push_back(values[i].second); });
  made.repeats = true;
  return made.with_commas();
}

/// A command: its function, and the description from which `--help`, the manual page and shell
/// completions are generated.
struct Command {
  std::string name;  ///< "analyze"
  std::string summary;
  std::vector<CommandOption> options;  ///< options and arguments
  std::vector<Command> commands;       ///< subcommands
  std::string notes;                   ///< text and examples printed below the options
  std::function<int(const Console&)>
      run;  ///< returns the exit code; empty if a subcommand is required

  std::vector<CommandOption> arguments() const;
  std::vector<CommandOption> named_options() const;  ///< options and flags
};

/// The options, each of which requires another one.
std::vector<CommandOption> that_need(const std::string& option, std::vector<CommandOption> options);

/// Concatenates options and lists of options.
template <class... Parts>
std::vector<CommandOption> all_of(const Parts&... parts) {
  std::vector<CommandOption> all;
  const auto add = [&](const auto& part) {
    if constexpr (requires { part.begin(); }) {
      all.insert(all.end(), part.begin(), part.end());
    } else {
      all.push_back(part);
    }
  };
  (add(parts), ...);
  return all;
}

/// A command and its full name as typed: "mien study analyze".
struct CommandPage {
  std::string name;
  const Command& command;
};

/// The command and all its subcommands, parents first.
std::vector<CommandPage> all_command_pages(const Command& program);

/// The direct subcommand of that name; nullptr if there is none.
const Command* subcommand_named(const Command& command, const std::string& name);

}  // namespace mien::pipeline
