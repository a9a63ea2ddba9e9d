#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "render/image/window.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

enum class Quality { draft, standard, final, reference };
enum class FrameFormat { none, png, png16, exr, layers };

inline constexpr Words<Quality> quality_words = {{"draft", Quality::draft},
                                                 {"standard", Quality::standard},
                                                 {"final", Quality::final},
                                                 {"reference", Quality::reference}};

inline constexpr Words<FrameFormat> frame_format_words = {{"none", FrameFormat::none},
                                                          {"png", FrameFormat::png},
                                                          {"png16", FrameFormat::png16},
                                                          {"exr", FrameFormat::exr},
                                                          {"layers", FrameFormat::layers}};

inline std::string_view name_of(Quality quality) { return word_of(quality_words, quality); }

/// What a video shows before and after the film, in this order: card, fixation cross, blank, film,
/// blank. Each duration is rounded to the nearest whole number of frames. Frame files contain only
/// the film.
struct Presentation {
  std::string card;               ///< text, with lines separated by \n; empty for none
  double card_seconds = 2.0;      ///< duration of the card, if there is a text
  double fixation_seconds = 0.0;  ///< duration of a cross in the centre
  int fixation_size = 32;         ///< width and height of the cross, in pixels before scaling
  double blank_before = 0.0;      ///< seconds
  double blank_after = 0.0;       ///< seconds
  double fade_in = 0.0;           ///< duration of the film's fade from the background, in seconds
  double fade_out = 0.0;          ///< duration of the film's fade to the background, in seconds
  double background = 0.5;        ///< grey, sRGB: 0 black … 1 white

  friend bool operator==(const Presentation&, const Presentation&) = default;
};

void fields_of(auto&& field, MaybeConst<Presentation> auto& shown) {
  field.group("card", [&](auto& card) {
    card("text", shown.card, concerns::shown | concerns::alone);
    card("seconds", shown.card_seconds, concerns::shown);
  });
  field.group("fixation", [&](auto& cross) {
    cross("seconds", shown.fixation_seconds, concerns::shown | concerns::alone);
    cross("size", shown.fixation_size, concerns::shown);
  });
  field("blank_before", shown.blank_before, concerns::shown);
  field("blank_after", shown.blank_after, concerns::shown);
  field("fade_in", shown.fade_in, concerns::shown);
  field("fade_out", shown.fade_out, concerns::shown);
  field("background", shown.background, concerns::shown);
}

/// `clips: [bvh, glb]`, stored in the order of motion::motion_formats().
struct ClipsForm {
  static void read(const DocumentValue& given, std::vector<std::string>& clips);
  static nlohmann::ordered_json write(const std::vector<std::string>& clips, const WritingOptions&);
};

/// `video: [mp4, gif]`, stored in the order of render::video_kinds().
struct VideoKindsForm {
  static void read(const DocumentValue& given, std::vector<render::VideoKind>& video);
  static nlohmann::ordered_json write(const std::vector<render::VideoKind>& video,
                                      const WritingOptions&);
};

/// The files written for a stimulus, their format and size.
struct Output {
  std::array<int, 2> size{960, 540};  ///< width and height of the camera's picture, before scaling
  /// Factor by which the picture's resolution is multiplied; the view is unchanged.
  double scale = 1.0;
  std::optional<std::array<int, 4>> crop;  ///< the part of the picture that is kept, in pixels of
                                           ///< `size`: left, top, width, height
  double fps = 30.0;
  int cycles = 3;         ///< repetitions of a looping clip
  bool in_place = false;  ///< remove travel (walk on the spot)
  Quality quality = Quality::standard;
  int samples = 256;     ///< per pixel, in reference quality
  double shutter = 0.0;  ///< shutter angle for motion blur, degrees: 360 is the whole frame
  FrameFormat frames = FrameFormat::png;
  std::vector<render::VideoKind> video{render::VideoKind::mp4};  ///< without duplicates
  Presentation presentation;
  /// File extensions of the exported motions, clips/<id>.bvh.
  std::vector<std::string> clips{"bvh"};

  /// Returns the width and height of the whole picture in pixels, after scaling.
  std::array<int, 2> whole_size() const;

  /// Returns the part of the whole picture that `crop` keeps, in pixels after scaling; empty if all
  /// of it is kept.
  std::optional<render::Window> window() const;

  /// Returns the width and height of frames and videos in pixels, after scaling and cropping.
  std::array<int, 2> shown_size() const;

  friend bool operator==(const Output&, const Output&) = default;
};

void fields_of(auto&& field, MaybeConst<Output> auto& output) {
  field("size", output.size, concerns::picture);
  field("scale", output.scale, concerns::picture);
  field("crop", output.crop, concerns::picture);
  field("fps", output.fps, concerns::motion | concerns::picture);
  field("in_place", output.in_place, concerns::motion | concerns::picture);
  field("quality", output.quality, concerns::picture | concerns::drawing, quality_words);
  field("samples", output.samples, concerns::picture | concerns::drawing);
  field("shutter", output.shutter, concerns::picture | concerns::drawing);
  field("cycles", output.cycles, concerns::motion);
  field("frames", output.frames, concerns::stored, frame_format_words);
  field.by("video", output.video, concerns::files, VideoKindsForm());
  field("presentation", output.presentation, concerns::shown);
  field.by("clips", output.clips, concerns::files, ClipsForm());
}

}  // namespace mien::pipeline
