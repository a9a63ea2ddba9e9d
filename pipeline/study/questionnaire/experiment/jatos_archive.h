#pragma once

#include <string>

#include "pipeline/production/archive/zip_archive.h"

namespace mien::pipeline {

/// What JATOS is told of a study.
struct JatosStudy {
  std::string title;
  std::string description;
  std::string folder;  ///< of its assets: letters, digits, - and _
  std::string key;     ///< the same for each export of a study, which JATOS then replaces
};

/// A study as JATOS imports it (.jzip): a zip archive of "<folder>.jas", which describes a study of
/// one component and one batch as version 3 of that format does, and of the assets in "<folder>/".
/// `assets` has an index.html, which is the component.
///
/// The format is that of JATOS 3 (jatos.org, "Export and import of studies"). The same study gives
/// the same bytes.
std::string jatos_archive(const JatosStudy& study, const ZipFiles& assets);

/// The page of an export as JATOS shows it: with its script before the page's own (`script`,
/// "questionnaire.js"), and without a policy that would keep it from talking to its server.
std::string page_of_jatos(std::string page, const std::string& script);

/// A UUID of version 8 (RFC 9562), which follows from the name.
std::string named_uuid(const std::string& name);

}  // namespace mien::pipeline
