#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// What participants are shown of a stimulus.
struct MediaFile {
  std::filesystem::path file;  ///< in the study's folder
  std::string token;           ///< what it is called in public; tells nothing of the stimulus
  std::string ending;          ///< ".mp4"
  std::string type;            ///< "video/mp4"
  std::string sha256;
  double seconds = 0.0;
  int width = 0;  ///< pixels; 0 of a motion that is turned
  int height = 0;
};

/// By the ids of stimuli.
using MediaFiles = std::map<std::string, MediaFile>;

/// The manifest with the motion files that its questionnaire shows among what is made. Throws Error
/// where stimuli that are shown have no video that browsers play.
Manifest with_media(Manifest manifest);

/// The media of all stimuli in the plans, found in the folder of the study, which has been made.
/// Throws Error for what is not there.
MediaFiles media_of(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                    const std::filesystem::path& folder);

/// How a stimulus is called where participants might see it: letters and digits that follow from
/// the study's seed.
std::string media_token(const Manifest& manifest, const std::string& stimulus);

}  // namespace mien::pipeline
