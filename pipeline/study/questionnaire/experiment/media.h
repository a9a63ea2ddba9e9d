#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/experiment/turned_motions.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// The media file of a stimulus.
struct MediaFile {
  std::filesystem::path file;  ///< in the study's folder
  std::string token;           ///< public name, which does not reveal the stimulus
  std::string ending;          ///< file extension: ".mp4"
  std::string type;            ///< media type: "video/mp4"
  std::string sha256;
  double seconds = 0.0;  ///< duration
  int width = 0;         ///< pixels; 0 for a 3-D motion
  int height = 0;
  bool has_sound = false;
  std::vector<FigureFile> figures = {};  ///< that a turned motion shows
};

/// Media type of the GLB files of motions and figures.
inline constexpr char glb_type[] = "model/gltf-binary";

/// Media files by stimulus id.
using MediaFiles = std::map<std::string, MediaFile>;

/// The manifest with output enabled for the 3-D motions that its questionnaire shows. Throws Error
/// if the questionnaire shows videos and a shown stimulus has none that browsers can play.
Manifest with_media(Manifest manifest);

/// The media of all stimuli in the plans, in the output folder of the study; motions that are
/// turned are written there (turned_motions.h). Throws Error for missing files.
MediaFiles media_of(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                    const std::filesystem::path& folder);

/// Public name of a stimulus: letters and digits derived from the study's seed.
std::string media_token(const Manifest& manifest, const std::string& stimulus);

}  // namespace mien::pipeline
