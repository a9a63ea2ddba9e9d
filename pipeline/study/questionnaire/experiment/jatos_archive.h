#pragma once

#include <string>

#include "pipeline/production/archive/zip_archive.h"

namespace mien::pipeline {

/// Properties of a study for JATOS.
struct JatosStudy {
  std::string title;
  std::string description;
  std::string folder;  ///< folder of its assets: letters, digits, - and _
  std::string
      key;  ///< the same for every export of a study, so that JATOS replaces the earlier one
};

/// A study archive for import into JATOS (.jzip): a zip archive with "<folder>.jas", which
/// describes a study with one component and one batch in version 3 of the format, and the assets in
/// "<folder>/". `assets` must contain an index.html, which is the component.
///
/// The format is that of JATOS 3 (jatos.org, "Export and import of studies"). The same study
/// results in the same bytes.
std::string jatos_archive(const JatosStudy& study, const ZipFiles& assets);

/// The page of an export adapted for JATOS: its meta tag "mien-mode" is "jatos", it loads JATOS's
/// script before the page's own script (`script`: "questionnaire.js") and lacks the content
/// security policy, which would block requests to the JATOS server.
std::string jatos_page(std::string page, const std::string& script);

/// A UUID of version 8 (RFC 9562), derived from the name.
std::string named_uuid(const std::string& name);

}  // namespace mien::pipeline
