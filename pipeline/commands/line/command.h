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

/// What an option sets: a variable, or whatever a function makes of each text that is given ("true"
/// of a flag). It has to live as long as the command. Nothing in a command that another program
/// told.
using BoundVariable =
    std::variant<std::monostate, bool*, int*, double*, std::uint64_t*, std::string*,
                 std::optional<int>*, std::optional<double>*, std::optional<std::uint64_t>*,
                 std::optional<std::string>*, std::vector<double>*, std::vector<std::string>*,
                 std::function<void(const std::string&)>>;

/// What may stand behind a command: an option or a flag (with names), or an argument (without).
struct CommandOption {
  std::vector<std::string> names;    ///< "-o", "--output"; empty for an argument
  std::string former;                ///< name it had: understood, with a warning; not shown
  std::string argument;              ///< "files"; empty for an option
  std::string value;                 ///< what it takes: "TEXT", "INT", …; empty for a flag
  std::vector<std::string> choices;  ///< all that it takes; empty when it takes other things
  std::string limits;                ///< "1 to 240"; empty when there are none
  std::string usual;                 ///< what it is when nobody says; empty when nothing is
  std::string help;
  bool is_required = false;
  bool repeats = false;  ///< takes several values

  BoundVariable variable;
  double least = 0.0;  ///< of the limits; above it, where there is no largest
  double largest = std::numeric_limits<double>::infinity();
  std::optional<std::pair<int, int>> value_count;        ///< how many values at one time
  bool has_commas = false;                               ///< between values
  std::string excluded;                                  ///< the option that it cannot stand with
  std::string needed;                                    ///< the one that it cannot stand without
  std::string group;                                     ///< heading of its own in --help
  std::function<std::string(const std::string&)> fault;  ///< of a value; empty when it is good
  std::vector<std::string>* given = nullptr;             ///< takes its name when it is used

  bool is_argument() const { return names.empty(); }
  bool takes_number() const { return value == "INT" || value == "UINT" || value == "FLOAT"; }

  // What a command says of an option that it lists.
  CommandOption required() const;
  CommandOption optional() const;
  CommandOption one_of(std::vector<std::string> words) const;
  CommandOption between(double low, double high) const;
  CommandOption positive() const;
  CommandOption with_default() const;  ///< shows what the variable is now
  CommandOption with_default(std::string text) const;
  CommandOption with_commas() const;
  CommandOption values(int fewest, int most) const;
  CommandOption excludes(std::string option) const;
  CommandOption needs(std::string option) const;
  CommandOption in_group(std::string heading) const;
  CommandOption formerly(std::string name) const;  ///< takes its old name too
};

/// `names`: "--out,-o".
CommandOption option(const std::string& names, BoundVariable variable, std::string help);
CommandOption flag(const std::string& names, BoundVariable variable, std::string help);

/// A word by its place, which is required.
CommandOption argument(std::string name, BoundVariable variable, std::string help);

/// An option that takes one of these words, of which `take` gets the place. A fault names them.
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

/// An option of words that stand for values.
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

/// Likewise one of several, with commas between them.
template <class Value>
CommandOption choice(const std::string& names, std::vector<Value>& variable,
                     const WordValues<Value>& values, std::string help) {
  CommandOption made =
      choice_of(names, names_of(values), std::move(help),
                [&variable, values](std::size_t i) { variable.push_back(values[i].second); });
  made.repeats = true;
  return made.with_commas();
}

/// A command of the program, as a value: what its `--help`, the manual page and the shells'
/// completions tell, and what it does.
struct Command {
  std::string name;  ///< "analyze"
  std::string summary;
  std::vector<CommandOption> options;      ///< and arguments
  std::vector<Command> commands;           ///< below it
  std::string notes;                       ///< with examples; what stands below the options
  std::function<int(const Console&)> run;  ///< returns the exit code; empty: one below is needed

  std::vector<CommandOption> arguments() const;
  std::vector<CommandOption> named_options() const;  ///< options and flags
};

/// Options and lists of them, one after the other.
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

/// A command and its name as it is typed: "mien study analyze".
struct CommandPage {
  std::string name;
  const Command& command;
};

/// The command and all below it, parents first.
std::vector<CommandPage> every_page(const Command& program);

/// The one below it of that name; null where there is none.
const Command* command_below(const Command& command, const std::string& name);

}  // namespace mien::pipeline
