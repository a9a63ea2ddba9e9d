#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/verify.h"

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

/// Everything of a study but the bookkeeping, by path: the artifacts of the provenance and all else
/// in the folder. Throws Error for what is neither a file nor a folder.
std::vector<PayloadFile> payload_of(const StudyContents& contents);

/// Writes a study as a bag (BagIt, RFC 8493) into a tar archive, in a folder of the study's name:
///
///   quickstart/bag-info.txt, bagit.txt
///   quickstart/data/…              the study
///   quickstart/manifest-sha256.txt, tagmanifest-sha256.txt
///
/// The same study and `info` give the same bytes. Throws Error for a name of another kind of
/// archive and for one within the study's folder, Interrupted after a stop request, and
/// std::runtime_error when a file changes meanwhile or the archive cannot be written; then none is
/// left.
void pack(const StudyContents& contents, const std::vector<PayloadFile>& payload,
          const BagInfo& info, const std::filesystem::path& archive, const std::stop_token& stop,
          const ShareDone& done);

/// Throws as `pack` does for the archive's name, before any work.
void refuse_archive(const StudyContents& contents, const std::filesystem::path& archive);

}  // namespace mien::pipeline
