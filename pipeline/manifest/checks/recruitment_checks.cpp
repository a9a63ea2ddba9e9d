#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <string_view>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/recruitment.h"

namespace mien::pipeline {

namespace {

bool is_parameter_name(const std::string& name) {
  const auto is_plain = [](unsigned char one) {
    return std::isalnum(one) != 0 || one == '_' || one == '-';
  };
  return !name.empty() && name.size() <= 64 && std::isalpha(static_cast<unsigned char>(name[0])) &&
         std::ranges::all_of(name, is_plain);
}

/// What is wrong with the placeholders of a redirect; empty if nothing is.
std::string placeholder_fault(const std::string& address) {
  for (const char* foreign : {"{{", "%SURVEY_CODE%"})
    if (address.find(foreign) != address.npos)
      return "has a placeholder as recruitment services write it, " + motion::in_quotes(foreign);
  for (const std::string& name : placeholders_of(address))
    if (!is_parameter_name(name))
      return motion::in_quotes("{" + name + "}") + " names no URL parameter";
  if (std::ranges::count(address, '{') != std::ranges::count(address, '}'))
    return "has a brace without its counterpart";
  return "";
}

/// Checks the address of a redirect, and its placeholders.
void check_redirect(FaultList& list, const std::string& path, const std::string& address) {
  if (!address.starts_with("https://") && !address.starts_with("http://"))
    list.add(path, motion::in_quotes(address) + " is no web address",
             "begin it with https:// (or http://), as the recruitment service shows it");
  const std::string fault = placeholder_fault(address);
  const bool has_blank = std::ranges::any_of(
      address, [](unsigned char one) { return one <= ' ' || one == '"' || one == '<'; });
  if (!fault.empty())
    list.add(path, fault, "write the parameter's name in single braces: {survey_code}");
  else if (has_blank)
    list.add(path, "has a character that no web address has", "copy it again");
}

}  // namespace

std::vector<Fault> check_recruitment(const Manifest& manifest) {
  if (!manifest.questionnaire) return {};
  const Recruitment& recruitment = manifest.questionnaire->recruitment;
  FaultList list(manifest.places);
  const std::string at = member_path("questionnaire", "recruitment");
  std::vector<std::string> met;
  for (std::size_t i = 0; i < recruitment.url_parameters.size(); ++i) {
    const std::string& name = recruitment.url_parameters[i];
    if (std::ranges::find(met, name) != met.end())
      list.add(element_path(member_path(at, "url_parameters"), i),
               motion::in_quotes(name) + " appears twice", "name it once");
    met.push_back(name);
  }
  std::map<std::string, std::string_view> codes;
  for (const auto& [word, end] : session_end_words) {
    const std::string& code = recruitment.prolific.of(end);
    const auto [first, is_new] = codes.emplace(code, word);
    if (!code.empty() && !is_new)
      list.add(member_path(member_path(at, "prolific"), std::string(word)),
               motion::in_quotes(code) + " is also the code of " + std::string(first->second),
               "make a code for each end at Prolific");
    const std::string& address = recruitment.redirect.of(end);
    if (address.empty()) continue;
    const std::string path = member_path(member_path(at, "redirect"), std::string(word));
    check_redirect(list, path, address);
    if (!recruitment.prolific.of(end).empty())
      list.add(path, "participants are sent back to Prolific at this end already",
               "remove either this address or prolific's code");
  }
  if (recruitment.pseudonymise && kept_parameters(recruitment).empty())
    list.add(member_path(at, "pseudonymise"), "there are no URL parameters to hash",
             "add url_parameters: [PROLIFIC_PID], or remove it");
  return list.take();
}

}  // namespace mien::pipeline
