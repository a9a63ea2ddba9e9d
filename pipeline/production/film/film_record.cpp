#include "pipeline/production/film/film_record.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/safe_name.h"

namespace mien::pipeline {

using nlohmann::ordered_json;

namespace {

ordered_json video_sound_json(const VideoSoundRecord& sound) {
  ordered_json entry = {{"codec", sound.codec},       {"rate", sound.rate},
                        {"channels", sound.channels}, {"frames", sound.frames},
                        {"hash", sound.hash},         {"correlation", sound.correlation}};
  if (sound.offset_frames) entry["offset_frames"] = *sound.offset_frames;
  return entry;
}

VideoSoundRecord video_sound_of(const nlohmann::json& entry) {
  VideoSoundRecord sound{.codec = entry.at("codec"),
                         .rate = entry.at("rate"),
                         .channels = entry.at("channels"),
                         .frames = entry.at("frames"),
                         .hash = entry.at("hash"),
                         .offset_frames = {},
                         .correlation = entry.at("correlation")};
  if (entry.contains("offset_frames")) sound.offset_frames = entry.at("offset_frames");
  return sound;
}

ordered_json sound_json(const SoundRecord& sound) {
  ordered_json entry = {{"file", sound.file},         {"of", sound.of},
                        {"offset_s", sound.offset_s}, {"gain_db", sound.gain_db},
                        {"length", sound.length},     {"source_s", sound.source_s},
                        {"channels", sound.channels}, {"held_frames", sound.held_frames},
                        {"cut_s", sound.cut_s},       {"silence_s", sound.silence_s}};
  if (sound.loudness_lufs) entry["loudness_lufs"] = *sound.loudness_lufs;
  if (sound.true_peak_dbtp) entry["true_peak_dbtp"] = *sound.true_peak_dbtp;
  return entry;
}

SoundRecord sound_of(const nlohmann::json& entry) {
  SoundRecord sound{.file = entry.at("file"),
                    .of = entry.at("of"),
                    .offset_s = entry.at("offset_s"),
                    .gain_db = entry.at("gain_db"),
                    .length = entry.at("length"),
                    .source_s = entry.at("source_s"),
                    .channels = entry.at("channels"),
                    .held_frames = entry.at("held_frames"),
                    .cut_s = entry.at("cut_s"),
                    .silence_s = entry.at("silence_s"),
                    .loudness_lufs = {},
                    .true_peak_dbtp = {}};
  if (entry.contains("loudness_lufs")) sound.loudness_lufs = entry.at("loudness_lufs");
  if (entry.contains("true_peak_dbtp")) sound.true_peak_dbtp = entry.at("true_peak_dbtp");
  return sound;
}

}  // namespace

ordered_json video_json(const VideoRecord& video) {
  ordered_json json = {
      {"file", video.file}, {"format", video.format},         {"frames", video.frames},
      {"fps", video.fps},   {"duration_s", video.duration_s}, {"identical", video.identical}};
  if (!video.frames_hash.empty()) json["frames_hash"] = video.frames_hash;
  if (video.sound) json["sound"] = video_sound_json(*video.sound);
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
  video.frames_hash = json.value("frames_hash", std::string());
  if (json.contains("sound")) video.sound = video_sound_of(json.at("sound"));
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

VideoSoundRecord video_sound_record(const render::SoundCheck& check) {
  VideoSoundRecord sound;
  sound.codec = check.codec;
  sound.rate = render::sound_rate;
  sound.channels = check.channels;
  sound.frames = check.frames;
  sound.hash = fmt::format("{:016x}", check.hash);
  if (check.match.offset_frames) sound.offset_frames = static_cast<int>(*check.match.offset_frames);
  sound.correlation = std::round(1000.0 * check.match.correlation) / 1000.0;
  return sound;
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
  if (record.sound) json["sound"] = sound_json(*record.sound);
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
    if (json.contains("sound")) record.sound = sound_of(json.at("sound"));
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
