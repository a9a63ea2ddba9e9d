#include "pipeline/production/film/film_record.h"

#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "motion/text/safe_name.h"

namespace mien::pipeline {

using nlohmann::ordered_json;

ordered_json video_json(const VideoRecord& video) {
  ordered_json json = {
      {"file", video.file}, {"format", video.format},         {"frames", video.frames},
      {"fps", video.fps},   {"duration_s", video.duration_s}, {"identical", video.identical}};
  if (video.identical) return json;
  json["worst_psnr_db"] = video.worst_psnr_db;
  json["worst_psnr_frame"] = video.worst_psnr_frame;
  json["worst_ssim"] = video.worst_ssim;
  json["worst_ssim_frame"] = video.worst_ssim_frame;
  return json;
}

VideoRecord video_record_of(const nlohmann::json& json) {
  VideoRecord video{.file = json.at("file"),
                    .format = json.at("format"),
                    .frames = json.at("frames"),
                    .fps = json.at("fps"),
                    .duration_s = json.at("duration_s"),
                    .identical = json.at("identical")};
  if (video.identical) return video;
  video.worst_psnr_db = json.at("worst_psnr_db");
  video.worst_psnr_frame = json.at("worst_psnr_frame");
  video.worst_ssim = json.at("worst_ssim");
  video.worst_ssim_frame = json.at("worst_ssim_frame");
  return video;
}

VideoRecord video_record(const std::string& file, render::VideoKind kind, double fps,
                         const render::VideoCheck& check) {
  VideoRecord video{.file = file,
                    .format = std::string(render::traits_of(kind).name),
                    .frames = check.frames,
                    .fps = fps,
                    .duration_s = check.frames / fps,
                    .identical = check.identical};
  if (video.identical) return video;
  // As many digits as mean something, so that no machine's logarithm shows.
  video.worst_psnr_db = std::round(100.0 * check.worst_psnr_db) / 100.0;
  video.worst_psnr_frame = check.worst_psnr_frame;
  video.worst_ssim = std::round(1e4 * check.worst_ssim) / 1e4;
  video.worst_ssim_frame = check.worst_ssim_frame;
  return video;
}

std::string film_record_text(const FilmRecord& record) {
  const render::ClipLuminance& luminance = record.luminance;
  ordered_json videos = ordered_json::array();
  for (const VideoRecord& video : record.videos) videos.push_back(video_json(video));
  ordered_json json = {{"film_frames", record.film_frames},
                       {"first_film_frame", record.first_film_frame},
                       {"exposure_stops", record.exposure_stops},
                       {"figure_px", record.figure_px},
                       {"luminance",
                        {{"frames", luminance.frames},
                         {"mean", luminance.mean},
                         {"deviation", luminance.deviation},
                         {"rms_contrast", luminance.rms_contrast},
                         {"darkest", luminance.darkest},
                         {"lightest", luminance.lightest}}},
                       {"videos", videos}};
  if (!record.warnings.empty()) json["warnings"] = record.warnings;
  if (record.figure_place) json["figure_place"] = *record.figure_place;
  if (record.visual_degrees) json["visual_degrees"] = *record.visual_degrees;
  return json.dump(2) + "\n";
}

FilmRecord parse_film_record(const std::string& text) {
  FilmRecord record;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    record.film_frames = json.at("film_frames");
    record.first_film_frame = json.at("first_film_frame");
    record.exposure_stops = json.at("exposure_stops");
    record.figure_px = json.at("figure_px");
    if (json.contains("figure_place")) record.figure_place = json.at("figure_place");
    if (json.contains("visual_degrees")) record.visual_degrees = json.at("visual_degrees");
    const nlohmann::json& luminance = json.at("luminance");
    record.luminance = {.frames = luminance.at("frames"),
                        .mean = luminance.at("mean"),
                        .deviation = luminance.at("deviation"),
                        .rms_contrast = luminance.at("rms_contrast"),
                        .darkest = luminance.at("darkest"),
                        .lightest = luminance.at("lightest")};
    record.warnings = json.value("warnings", record.warnings);
    for (const nlohmann::json& video : json.at("videos")) {
      record.videos.push_back(video_record_of(video));
      motion::safe_names(record.videos.back().file, {});
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("no record of a film: ") + error.what());
  }
  return record;
}

}  // namespace mien::pipeline
