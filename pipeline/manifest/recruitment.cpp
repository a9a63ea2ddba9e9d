#include "pipeline/manifest/recruitment.h"

#include <algorithm>

namespace mien::pipeline {

const std::string& SessionEndTexts::of(SessionEnd end) const {
  switch (end) {
    case SessionEnd::screened_out:
      return screened_out;
    case SessionEnd::refused:
      return refused;
    case SessionEnd::withdrawn:
      return withdrawn;
    case SessionEnd::failed_attention:
      return failed_attention;
    default:
      return completed;
  }
}

std::vector<std::string> placeholders_of(const std::string& redirect) {
  std::vector<std::string> names;
  for (std::size_t at = 0; (at = redirect.find('{', at)) != redirect.npos;) {
    const std::size_t end = redirect.find('}', at);
    if (end == redirect.npos) break;
    names.push_back(redirect.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return names;
}

std::vector<std::string> kept_parameters(const Recruitment& recruitment) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const std::string& name : recruitment.url_parameters) add(name);
  if (recruitment.prolific != SessionEndTexts())
    for (const char* name : {"PROLIFIC_PID", "STUDY_ID", "SESSION_ID"}) add(name);
  for (const auto& [word, end] : session_end_words)
    for (const std::string& name : placeholders_of(recruitment.redirect.of(end))) add(name);
  return names;
}

std::string address_after(const Recruitment& recruitment, SessionEnd end) {
  const std::string& code = recruitment.prolific.of(end);
  return code.empty() ? recruitment.redirect.of(end)
                      : "https://app.prolific.com/submissions/complete?cc=" + code;
}

}  // namespace mien::pipeline
