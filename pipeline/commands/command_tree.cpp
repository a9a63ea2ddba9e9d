#include "pipeline/commands/command_tree.h"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace mien::pipeline {

namespace {

std::vector<std::string> split_at(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

/// "INT in [1 - 1024]" as "1 to 1024".
std::string plain_limits(const std::string& told) {
  if (told == "POSITIVE") return "more than 0";
  const std::size_t open = told.find("in [");
  const std::size_t dash = told.find(" - ");
  if (open == std::string::npos || dash == std::string::npos || !told.ends_with(']')) return told;
  return told.substr(open + 4, dash - open - 4) + " to " +
         told.substr(dash + 3, told.size() - dash - 4);
}

/// Takes "draft|final [draft]", "TEXT:{draft,final}" or "INT:INT in [1 - 9]" apart.
void read_value(std::string told, CommandOption& option) {
  if (const std::size_t open = told.find(" [");
      open != std::string::npos && told.ends_with(']') && told.find(" in [") == std::string::npos) {
    option.usual = told.substr(open + 2, told.size() - open - 3);
    told.resize(open);
  }
  if (told.find('|') != std::string::npos) {
    option.value = "TEXT";
    option.choices = split_at(told, '|');
    return;
  }
  const std::size_t colon = std::min(told.find(':'), told.size());
  option.value = told.substr(0, colon);
  const std::string rest = told.substr(std::min(colon + 1, told.size()));
  if (rest.starts_with('{') && rest.ends_with('}')) {
    option.choices = split_at(rest.substr(1, rest.size() - 2), ',');
  } else {
    option.limits = plain_limits(rest);
  }
}

CommandOption option_told(const CLI::Option& told) {
  CommandOption option;
  for (const std::string& name : told.get_snames()) option.names.push_back("-" + name);
  for (const std::string& name : told.get_lnames()) option.names.push_back("--" + name);
  if (option.names.empty()) option.argument = told.get_name(true);
  option.help = told.get_description();
  option.usual = told.get_default_str();
  option.required = told.get_required();
  option.repeats = told.get_items_expected_max() > 1;
  const bool takes_value = told.get_type_size() != 0;
  if (takes_value) {
    const std::string& text = told.get_option_text();
    read_value(text.empty() ? told.get_type_name() : text, option);
  }
  return option;
}

void add_commands(const CLI::App& app, CommandPage& page);

CommandPage page_of(const CLI::App& app, const std::string& name, const std::string& above) {
  CommandPage page;
  page.name = name;
  page.summary = app.get_description();
  if (app.get_footer() != above) page.notes = app.get_footer();
  for (const CLI::Option* told : app.get_options()) {
    if (told->get_group().empty() || told == app.get_help_ptr()) continue;
    CommandOption option = option_told(*told);
    (option.names.empty() ? page.arguments : page.options).push_back(std::move(option));
  }
  add_commands(app, page);
  return page;
}

void add_commands(const CLI::App& app, CommandPage& page) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_group().empty()) continue;
    page.commands.push_back(
        page_of(*command, page.name + " " + command->get_name(), app.get_footer()));
  }
}

}  // namespace

CommandPage command_tree(const CLI::App& app) { return page_of(app, app.get_name(), ""); }

std::string last_word(const CommandPage& page) {
  return page.name.substr(page.name.find_last_of(' ') + 1);
}

std::vector<const CommandPage*> every_page(const CommandPage& page) {
  std::vector<const CommandPage*> pages = {&page};
  for (const CommandPage& command : page.commands) {
    const std::vector<const CommandPage*> below = every_page(command);
    pages.insert(pages.end(), below.begin(), below.end());
  }
  return pages;
}

}  // namespace mien::pipeline
