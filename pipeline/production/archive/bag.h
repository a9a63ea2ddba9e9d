#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/production/archive/study_contents.h"

namespace mien::pipeline {

/// A file of a bag's payload.
struct PayloadFile {
  std::string path;         ///< in the study's folder
  std::uint64_t size = 0;   ///< bytes
  std::string sha256 = {};  ///< once it is known
};

/// What an archive likes to know of a bag, in the words of the RFC's bag-info.txt; what is empty is
/// left out.
struct BagInfo {
  std::string organization;   ///< Source-Organization
  std::string contact_name;   ///< Contact-Name
  std::string contact_email;  ///< Contact-Email
  std::string description;    ///< External-Description; without one, the command that made it
  std::string license;        ///< License, an element of our own
};

/// The files beside data/ that make a folder a bag of version 1.0 (BagIt, RFC 8493). No dates: the
/// same study gives the same bag.
std::string bagit_text();
std::string bag_info_text(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                          const BagInfo& info);

/// A line "<sha256>  <path>" a file, as `sha256sum -c` reads them; in paths, line ends and % are
/// written %0A, %0D and %25, as the RFC has it.
std::string bag_manifest_line(const std::string& sha256, const std::string& path);

}  // namespace mien::pipeline
