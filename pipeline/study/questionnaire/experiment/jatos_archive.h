#pragma once

#include <string>

#include "pipeline/production/archive/zip_archive.h"

namespace mien::pipeline {

/// Properties of a study for JATOS.
struct JatosStudy {
  std::string title;
  std::string description;
  std::string folder;  ///< folder of its assets: letters, digits, - and _
  std::string key;  ///< the same for each export of a study, so that JATOS replaces the earlier one
};

/// A study as JATOS imports it (.jzip): a zip archive of "<folder>.jas", which describes a study of
/// one component and one batch as version 3 of that format does, and of the assets in "<folder>/".
/// `assets` has an index.html, which is the component.
///
/// The format is that of JATOS 3 (jatos.org, "Export and import of studies"). The same study gives
/// the same bytes.
std::string jatos_archive(const JatosStudy& study, const ZipFiles& assets);

/// The page of an export adapted for JATOS: loads JATOS's script before the page's own (`script`,
/// "questionnaire.js"), and lacks the content security policy that would block requests to its
/// server.
std::string jatos_page(std::string page, const std::string& script);

/// A UUID of version 8 (RFC 9562), derived from the name.
std::string named_uuid(const std::string& name);

}  // namespace mien::pipeline
