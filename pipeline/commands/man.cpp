#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/programs.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

/// Removes and returns the first code point of valid UTF-8.
unsigned take_character(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  unsigned code = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length && i < text.size(); ++i)
    code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  text.remove_prefix(std::min(length, text.size()));
  return code;
}

/// Characters that roff would replace by typographic ones, and their roff escapes.
constexpr std::pair<char, const char*> roff_escapes[] = {
    {'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"}, {'"', "\\(dq"},
    {'`', "\\(ga"}, {'^', "\\(ha"}, {'~', "\\(ti"},
};

/// A text in roff, in ASCII.
std::string roff(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const unsigned code = take_character(text);
    const auto* kept = std::ranges::find_if(
        roff_escapes, [&](const auto& each) { return code == static_cast<unsigned>(each.first); });
    if (kept != std::end(roff_escapes)) {
      result += kept->second;
    } else {
      result +=
          code < 0x80 ? std::string(1, static_cast<char>(code)) : fmt::format("\\[u{:04X}]", code);
    }
  }
  return result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

/// A line in roff; a leading dot is escaped so that it is not a request.
std::string whole_line(std::string_view text) {
  return (text.starts_with('.') ? "\\&" : "") + roff(text) + "\n";
}

/// Running text in lines of at most 80 characters.
std::string running_text(const std::string& text) {
  constexpr std::size_t longest = 80;
  std::istringstream words(text);
  std::string page;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && roff(line + " " + word).size() > longest - 2) {
      page += whole_line(line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return page + whole_line(line);
}

/// Notes in roff: paragraphs of running text, and indented lines unchanged.
std::string notes_in_roff(const std::string& notes) {
  std::istringstream lines(notes);
  std::string page;
  bool is_shown = false;  // between .EX and .EE
  bool begins = true;
  for (std::string line; std::getline(lines, line);) {
    const bool indented = line.starts_with("  ");
    if (line.empty() && is_shown) page += ".EE\n";
    if (line.empty()) {
      is_shown = false;
      begins = true;
      continue;
    }
    if (indented != is_shown) {
      page += indented ? ".PP\n.EX\n" : ".EE\n";
      is_shown = indented;
    } else if (begins) {
      page += ".PP\n";
    }
    begins = false;
    page += indented ? whole_line(line) : running_text(line);
  }
  return page + (is_shown ? ".EE\n" : "");
}

std::string value_in_roff(const CommandOption& option) {
  if (option.choices.empty()) return italic(option.value);
  std::string choices;
  for (const std::string& choice : option.choices)
    choices += (choices.empty() ? "" : "|") + bold(choice);
  return choices;
}

std::string option_in_roff(const CommandOption& option) {
  std::string page = ".TP\n";
  for (const std::string& name : option.names)
    page += (&name == &option.names.front() ? "" : ", ") + bold(name);
  if (option.names.empty()) {
    page += italic(option.argument);
  } else if (!option.value.empty()) {
    page += " " + value_in_roff(option);
  }
  if (option.repeats) page += " .\\|.\\|.";
  std::string description = option.help;
  if (!option.limits.empty()) description += " (" + option.limits + ")";
  if (!option.usual.empty() && description.find("[" + option.usual + "]") == std::string::npos)
    description += " [" + option.usual + "]";
  if (option.is_required && !option.names.empty()) description += " (required)";
  return page + "\n" + running_text(description);
}

/// "mien run [options] manifest" in roff, with literal words in bold.
std::string usage_in_roff(const CommandPage& page) {
  std::string usage = bold(page.name);
  if (!page.command.named_options().empty()) usage += " [" + italic("options") + "]";
  for (const CommandOption& argument : page.command.arguments()) {
    const std::string name = italic(argument.argument) + (argument.repeats ? "\\ .\\|.\\|." : "");
    usage += argument.is_required ? " " + name : " [" + name + "]";
  }
  if (!page.command.commands.empty()) usage += " " + italic("command") + " .\\|.\\|.";
  return usage + "\n";
}

std::string command_in_roff(const CommandPage& page) {
  std::string text = ".SS " + roff(page.name) + "\n" + usage_in_roff(page) + ".PP\n" +
                     running_text(page.command.summary);
  for (const CommandOption& argument : page.command.arguments()) text += option_in_roff(argument);
  for (const CommandOption& option : page.command.named_options()) text += option_in_roff(option);
  return text + notes_in_roff(page.command.notes);
}

/// The indented lines of a text, unchanged.
std::string examples_in_roff(const std::string& notes) {
  std::istringstream lines(notes);
  std::string page = ".SH EXAMPLES\n.EX\n";
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ")) page += whole_line(line);
  return page + ".EE\n";
}

std::string exit_codes_in_roff() {
  std::string page = ".SH EXIT STATUS\n";
  for (const ExitCode& exit : exit_codes)
    page += ".TP\n" + bold(std::to_string(exit.code)) + "\n" + running_text(exit.meaning);
  return page;
}

constexpr char files_in_roff[] = R"(.SH FILES
.TP
\fIout/\fRstudy
Output of a run, in the current folder;
\fIreport.html\fR presents it on one page.
.TP
\fI../share/mien/manifests\fR
Relative to the program: the manifests installed with it, which
.B mien manifests
lists, and the JSON Schemas for editors.
)";

/// The manual page mien(1) with the macros of man(7), in ASCII: the contents of every `--help`,
/// exit codes and files. `version` is "0.2.0", `date` the release date, "2026-11-22".
std::string manual_page(const Command& program, const std::string& version,
                        const std::string& date) {
  const std::vector<CommandPage> pages = all_command_pages(program);
  std::string page = fmt::format(".TH MIEN 1 {} \"mien {}\" \"User Commands\"\n", date, version);
  page += ".SH NAME\nmien \\- make human motion stimuli\n.SH SYNOPSIS\n" + usage_in_roff(pages[0]);
  page += ".SH DESCRIPTION\n" + running_text(program.summary);
  page += "Results go to standard output, progress and faults to standard error.\n";
  page += ".SH OPTIONS\n.TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nShow help for a command.\n";
  for (const CommandOption& option : program.named_options()) page += option_in_roff(option);
  page += ".SH COMMANDS\n";
  for (std::size_t i = 1; i < pages.size(); ++i) page += command_in_roff(pages[i]);
  return page + exit_codes_in_roff() + files_in_roff + examples_in_roff(program.notes);
}

}  // namespace

Command man_command() {
  return {.name = "man",
          .summary = "Print the manual page",
          .notes = "Example:\n  mien man | man -l -",
          .run = [](const Console& console) {
            console.out << manual_page(with_external_programs(mien_program()),
                                       std::string(program_version()), std::string(release_date()));
            return exit_done;
          }};
}

}  // namespace mien::pipeline
