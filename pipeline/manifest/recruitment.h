#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/ratings/answers/session_end.h"

namespace mien::pipeline {

/// A completion code or a web address for each way in which a session can end; empty: none.
struct SessionEndTexts {
  std::string completed, screened_out, refused, withdrawn, failed_attention;

  const std::string& of(SessionEnd end) const;
  friend bool operator==(const SessionEndTexts&, const SessionEndTexts&) = default;
};

void fields_of(auto&& field, MaybeConst<SessionEndTexts> auto& texts) {
  field("completed", texts.completed, concerns::nothing);
  field("screened_out", texts.screened_out, concerns::nothing);
  field("refused", texts.refused, concerns::nothing);
  field("withdrawn", texts.withdrawn, concerns::nothing);
  field("failed_attention", texts.failed_attention, concerns::nothing);
}

/// Where participants come from, and where they go when their session has ended.
struct Recruitment {
  std::vector<std::string> url_parameters;  ///< those of the participant's link that are kept
  SessionEndTexts prolific;                 ///< completion codes of Prolific
  /// Web addresses, in which {NAME} stands for the URL parameter of that name.
  SessionEndTexts redirect;
  bool pseudonymise = false;  ///< keep hashes of the parameters instead of their values

  friend bool operator==(const Recruitment&, const Recruitment&) = default;
};

void fields_of(auto&& field, MaybeConst<Recruitment> auto& recruitment) {
  field("url_parameters", recruitment.url_parameters, concerns::nothing);
  field("prolific", recruitment.prolific, concerns::nothing);
  field("redirect", recruitment.redirect, concerns::nothing);
  field("pseudonymise", recruitment.pseudonymise, concerns::nothing);
}

/// The URL parameters that are kept, each once: those that are named, those of Prolific if it has
/// codes, and those of redirects.
std::vector<std::string> kept_parameters(const Recruitment& recruitment);

/// The names of the parameters in a redirect, in order: of "…?id={survey_code}", survey_code.
std::vector<std::string> placeholders_of(const std::string& redirect);

/// The web address to which a participant is sent, with placeholders; empty if there is none.
std::string address_after(const Recruitment& recruitment, SessionEnd end);

}  // namespace mien::pipeline
