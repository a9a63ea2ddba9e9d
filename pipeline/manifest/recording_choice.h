#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/formats/reading/read_options.h"
#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// The licence of a recording, as far as the manifest states one.
struct Licence {
  std::string name;   ///< "CC BY 4.0"; empty: not stated
  bool share = true;  ///< false: the recording must not be passed on (mien pack leaves it out)

  friend bool operator==(const Licence&, const Licence&) = default;
};

/// Which motion of a file is used, and what the file itself does not state.
struct RecordingChoice {
  std::string take;                 ///< of a file with several; empty: the first
  std::string subject;              ///< name or number of one of several people; empty: the first
  std::optional<double> fps;        ///< frame rate of the recording; none: as the file states it
  std::vector<std::string> joints;  ///< names of points that have none in the file
  /// SMPL model (.npz) that gives the body of SMPL motions, resolved; empty: mien's own body.
  std::filesystem::path body_model;
  Licence licence;
  std::string source;  ///< where the recording can be obtained; empty: not stated

  friend bool operator==(const RecordingChoice&, const RecordingChoice&) = default;
};

/// The choice as the readers of files take it.
inline motion::ReadOptions read_options(const RecordingChoice& choice) {
  motion::ReadOptions options;
  if (!choice.take.empty()) options.take = choice.take;
  if (!choice.subject.empty()) options.subject = choice.subject;
  options.frames_per_second = choice.fps;
  options.joints = choice.joints;
  options.body_model = choice.body_model;
  return options;
}

/// A subject is written as text, or as a number from 1.
struct SubjectForm {
  static void read(const DocumentValue& given, std::string& subject);
  static nlohmann::ordered_json write(const std::string& subject, const WritingOptions&);
};

/// The fields of the choice, which are written beside that of the file; a pose has no rate.
void pose_fields(auto&& field, auto& choice, unsigned concern) {
  field("take", choice.take, concern);
  field.by("subject", choice.subject, concern, SubjectForm());
  field("joints", choice.joints, concern);
  field("body_model", choice.body_model, concern);
  constexpr unsigned stated = concerns::page | concerns::unkeyed;
  field.group("licence", [&](auto& licence) {
    licence("name", choice.licence.name, stated | concerns::alone);
    licence("share", choice.licence.share, stated);
  });
  field("source", choice.source, stated);
}
void recording_fields(auto&& field, auto& choice, unsigned concern) {
  pose_fields(field, choice, concern);
  field("fps", choice.fps, concern);
}

}  // namespace mien::pipeline
