#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/manifest/packed_recordings.h"
#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/verify.h"

namespace mien::pipeline {

/// A file of a bag's payload.
struct PayloadFile {
  std::string path;                 ///< relative to the study's folder
  std::uint64_t size = 0;           ///< bytes
  std::string sha256 = {};          ///< not set: pack hashes the files itself
  std::filesystem::path from = {};  ///< file to read; empty: the one at `path`
  std::string text = {};            ///< the contents of a file that is only in the archive
};

/// Which recordings are packed with a study.
struct RecordingPacking {
  bool recordings = false;                                  ///< pack recordings, too
  bool restricted = false;                                  ///< pack even what must not be shared
  std::map<std::string, std::filesystem::path> files = {};  ///< recordings by their names
  std::map<std::string, std::string> folders = {};          ///< as in PackedRecordings
};

/// The files to be packed, and the recordings among them.
struct PackedStudy {
  std::vector<PayloadFile> payload;  ///< sorted by path
  PackedRecordings recordings;
  std::vector<std::string> stale;  ///< left out (stale_in_study)
};

/// Returns the files of a study (payload_of) with its recordings, if requested. Unless restricted
/// ones are requested, recordings that must not be shared are left out, and so are the motion files
/// made from them (ArtifactRecord::restricting): these carry the recorded movement. If recordings
/// are packed or something is left out, recordings.json says so. Throws Error if a recording does
/// not exist or has changed since the study was made.
PackedStudy packed_study(const StudyContents& contents, const RecordingPacking& packing);

/// Metadata of a bag, for its bag-info.txt (RFC 8493). Empty members are omitted, except
/// `description`.
struct BagInfo {
  std::string organization;   ///< Source-Organization
  std::string contact_name;   ///< Contact-Name
  std::string contact_email;  ///< Contact-Email
  std::string description;    ///< External-Description; if empty, the command that made the study
  std::string license;        ///< License (not a label of the RFC)
  std::string left_out;       ///< Left-Out (not a label of the RFC): what is not in the archive
  std::string published;      ///< date of publication, 2026-11-30; not in bag-info.txt
};

/// Return the contents of bagit.txt and bag-info.txt, which lie next to data/ in a bag of version
/// 1.0 (BagIt, RFC 8493). They contain no dates, so that the same study gives the same bag.
std::string bagit_text();
std::string bag_info_text(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                          const BagInfo& info);

/// Returns a line "<sha256>  <path>" as `sha256sum -c` reads it; in paths, line feeds, carriage
/// returns and % are encoded as %0A, %0D and %25, as the RFC requires.
std::string bag_manifest_line(const std::string& sha256, const std::string& path);

/// Paths of the artifacts in a study's folder that an earlier run made and the study no longer has,
/// sorted. Nothing is known about them, not even whether they may be shared.
std::vector<std::string> stale_in_study(const StudyContents& contents);

/// Paths with characters that the manifest of a bag encodes: sha256sum cannot find these files.
std::vector<std::string> encoded_paths(const std::vector<PayloadFile>& payload);

/// Returns all files in a study's folder except bookkeeping, stale artifacts and what was added by
/// an archive from which it was unpacked (is_only_in_archive), sorted by path. Frame sequences may
/// be links to folders. Throws Error for anything else that is neither a file nor a folder.
std::vector<PayloadFile> payload_of(const StudyContents& contents);

/// Writes a study as a bag (BagIt, RFC 8493) into a tar archive, in a folder with the study's name:
///
///   quickstart/bag-info.txt, bagit.txt
///   quickstart/data/…              the study
///   quickstart/manifest-sha256.txt, tagmanifest-sha256.txt
///
/// The same study and `info` give the same bytes (TarArchive). Throws Error if the archive's name
/// has an unsupported extension or is that of a folder, or if the archive would be within the
/// study's folder; Interrupted after a stop request; and std::runtime_error if a file's size
/// changes while it is packed or the archive cannot be written. No archive is left in these cases.
void pack(const StudyContents& contents, const std::vector<PayloadFile>& payload,
          const BagInfo& info, const std::filesystem::path& archive, const std::stop_token& stop,
          const ShareDone& done);

/// Throws the errors of `pack` that concern the archive's name and place, so that they are reported
/// before any work.
void refuse_archive(const StudyContents& contents, const std::filesystem::path& archive);

}  // namespace mien::pipeline
