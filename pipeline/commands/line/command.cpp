#include "pipeline/commands/line/command.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/text/nearest_word.h"

namespace mien::pipeline {

namespace {

/// "--out,-o" as {"-o", "--out"}: short names first, as --help has them.
std::vector<std::string> split_names(const std::string& names) {
  std::vector<std::string> result;
  std::istringstream stream(names);
  for (std::string name; std::getline(stream, name, ',');) result.push_back(name);
  std::stable_partition(result.begin(), result.end(),
                        [](const std::string& name) { return !name.starts_with("--"); });
  return result;
}

/// Name of a variable's type in --help, and whether it takes several values.
struct VariableKind {
  const char* value;
  bool repeats = false;

  VariableKind operator()(std::monostate) const { return {""}; }
  VariableKind operator()(const bool*) const { return {""}; }
  VariableKind operator()(const int*) const { return {"INT"}; }
  VariableKind operator()(const double*) const { return {"FLOAT"}; }
  VariableKind operator()(const std::uint64_t*) const { return {"UINT"}; }
  VariableKind operator()(const std::string*) const { return {"TEXT"}; }
  VariableKind operator()(const std::function<void(const std::string&)>&) const { return {"TEXT"}; }
  template <class Value>
  VariableKind operator()(const std::optional<Value>*) const {
    return (*this)(static_cast<const Value*>(nullptr));
  }
  template <class Value>
  VariableKind operator()(const std::vector<Value>*) const {
    return {(*this)(static_cast<const Value*>(nullptr)).value, true};
  }
};

struct VariableText {
  std::string operator()(std::string* text) const { return *text; }
  std::string operator()(int* number) const { return fmt::to_string(*number); }
  std::string operator()(std::uint64_t* number) const { return fmt::to_string(*number); }
  std::string operator()(double* number) const { return fmt::format("{:g}", *number); }
  std::string operator()(std::vector<double>* numbers) const {
    return fmt::format("[{:g}]", fmt::join(*numbers, ","));
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

CommandOption made(BoundVariable variable, std::string help) {
  CommandOption option;
  const VariableKind kind = std::visit(VariableKind{}, variable);
  option.value = kind.value;
  option.repeats = kind.repeats;
  option.variable = std::move(variable);
  option.help = std::move(help);
  return option;
}

/// A copy of an option with a changed property.
template <class Say>
CommandOption but(CommandOption option, Say say) {
  say(option);
  return option;
}

}  // namespace

CommandOption CommandOption::required() const {
  return but(*this, [](CommandOption& it) { it.is_required = true; });
}

CommandOption CommandOption::optional() const {
  return but(*this, [](CommandOption& it) { it.is_required = false; });
}

CommandOption CommandOption::one_of(std::vector<std::string> words) const {
  return but(*this, [&](CommandOption& it) { it.choices = std::move(words); });
}

CommandOption CommandOption::between(double low, double high) const {
  return but(*this, [&](CommandOption& it) {
    it.limits = fmt::format("{:.10g} to {:.10g}", low, high);
    it.least = low;
    it.largest = high;
  });
}

CommandOption CommandOption::positive() const {
  return but(*this, [](CommandOption& it) { it.limits = "more than 0"; });
}

CommandOption CommandOption::with_default() const {
  return with_default(std::visit(VariableText{}, variable));
}

CommandOption CommandOption::with_default(std::string text) const {
  return but(*this, [&](CommandOption& it) { it.usual = std::move(text); });
}

CommandOption CommandOption::with_commas() const {
  return but(*this, [](CommandOption& it) { it.has_commas = true; });
}

CommandOption CommandOption::values(int fewest, int most) const {
  return but(*this, [&](CommandOption& it) {
    it.value_count = {fewest, most};
    it.repeats = most > 1;
  });
}

CommandOption CommandOption::excludes(std::string option) const {
  return but(*this, [&](CommandOption& it) { it.excluded = std::move(option); });
}

CommandOption CommandOption::needs(std::string option) const {
  return but(*this, [&](CommandOption& it) { it.needed = std::move(option); });
}

CommandOption CommandOption::in_group(std::string heading) const {
  return but(*this, [&](CommandOption& it) { it.group = std::move(heading); });
}

CommandOption CommandOption::formerly(std::string name) const {
  return but(*this, [&](CommandOption& it) { it.former = std::move(name); });
}

CommandOption option(const std::string& names, BoundVariable variable, std::string help) {
  CommandOption option = made(std::move(variable), std::move(help));
  option.names = split_names(names);
  return option;
}

CommandOption flag(const std::string& names, BoundVariable variable, std::string help) {
  CommandOption flag = option(names, std::move(variable), std::move(help));
  flag.value.clear();
  return flag;
}

CommandOption argument(std::string name, BoundVariable variable, std::string help) {
  CommandOption argument = made(std::move(variable), std::move(help)).required();
  argument.argument = std::move(name);
  return argument;
}

CommandOption choice_of(const std::string& names, std::vector<std::string> words, std::string help,
                        std::function<void(std::size_t)> take) {
  const auto place_of = [words](const std::string& given) {
    return static_cast<std::size_t>(std::ranges::find(words, given) - words.begin());
  };
  CommandOption made = option(
      names, [=](const std::string& given) { take(place_of(given)); }, std::move(help));
  made.value = fmt::to_string(fmt::join(words, "|"));
  made.fault = [=](const std::string& given) -> std::string {
    if (place_of(given) < words.size()) return "";
    if (motion::nearest_word(given, words))
      return fmt::format("\"{}\": {}", given, motion::did_you_mean(given, words));
    const std::set<std::string> in_order(words.begin(), words.end());
    return fmt::format("\"{}\" is not one of {}", given, fmt::join(in_order, ", "));
  };
  made.choices = std::move(words);
  return made;
}

std::vector<CommandOption> Command::arguments() const {
  std::vector<CommandOption> result;
  std::ranges::copy_if(options, std::back_inserter(result), &CommandOption::is_argument);
  return result;
}

std::vector<CommandOption> Command::named_options() const {
  std::vector<CommandOption> result;
  std::ranges::remove_copy_if(options, std::back_inserter(result), &CommandOption::is_argument);
  return result;
}

std::vector<CommandPage> all_command_pages(const Command& program) {
  std::vector<CommandPage> pages = {{program.name, program}};
  for (const Command& command : program.commands)
    for (const CommandPage& below : all_command_pages(command))
      pages.push_back({program.name + " " + below.name, below.command});
  return pages;
}

const Command* subcommand_named(const Command& command, const std::string& name) {
  const auto found = std::ranges::find(command.commands, name, &Command::name);
  return found == command.commands.end() ? nullptr : &*found;
}

std::vector<CommandOption> that_need(const std::string& option,
                                     std::vector<CommandOption> options) {
  for (CommandOption& one : options) one = one.needs(option);
  return options;
}

}  // namespace mien::pipeline
