#pragma once

#include <filesystem>
#include <stop_token>
#include <vector>

#include "pipeline/production/archive/bag.h"
#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/verify.h"

namespace mien::pipeline {

/// Everything of a study but the bookkeeping, by path: what the provenance tells and what else lies
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
