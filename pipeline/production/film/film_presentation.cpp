#include "pipeline/production/film/film_presentation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/production/film/fixation_cross.h"
#include "render/image/tone.h"

namespace mien::pipeline {

namespace {

int whole_frames(double seconds, double fps) {
  return static_cast<int>(std::lround(seconds * fps));
}

std::uint8_t code_of(double level) { return static_cast<std::uint8_t>(std::lround(255.0 * level)); }

/// What each code becomes when it is mixed with the background in linear light.
std::array<std::uint8_t, 256> mixed_codes(std::uint8_t background, double share) {
  const double rest = (1.0 - share) * render::linear_from_srgb(background / 255.0);
  render::Framebuffer film(256, 1);
  for (int code = 0; code < 256; ++code) {
    const double light = share * render::linear_from_srgb(code / 255.0) + rest;
    std::fill_n(film.at(code, 0), 3, static_cast<float>(light));
  }
  const render::Image8 codes = render::to_srgb8(film, {.shoulder = 1.0f});
  std::array<std::uint8_t, 256> table{};
  for (int code = 0; code < 256; ++code) {
    table[static_cast<std::size_t>(code)] = codes.at(code, 0)[0];
  }
  return table;
}

/// The same picture so many times in a row.
render::Image8 side_by_side(const render::Image8& one, int times) {
  render::Image8 all(times * one.width, one.height);
  for (int y = 0; y < one.height; ++y) {
    for (int k = 0; k < times; ++k) {
      std::copy_n(one.at(0, y), 3 * one.width, all.at(k * one.width, y));
    }
  }
  return all;
}

}  // namespace

PresentationFrames frames_of(const Presentation& presentation, double fps, int film_frames) {
  PresentationFrames frames;
  if (!presentation.card.empty()) frames.card = whole_frames(presentation.card_seconds, fps);
  frames.fixation = whole_frames(presentation.fixation_seconds, fps);
  frames.blank_before = whole_frames(presentation.blank_before, fps);
  frames.film = film_frames;
  frames.blank_after = whole_frames(presentation.blank_after, fps);
  frames.fade_in = std::min(film_frames, whole_frames(presentation.fade_in, fps));
  frames.fade_out = std::min(film_frames, whole_frames(presentation.fade_out, fps));
  return frames;
}

Presenter::Presenter(const Output& output, int film_frames, int eyes)
    : output_(output),
      eyes_(eyes),
      frames_(frames_of(output.presentation, output.fps, film_frames)),
      background_(code_of(output.presentation.background)) {}

void Presenter::take(const render::Image8& picture, const Show& show) {
  const auto repeat = [&](const render::Image8& still, int count) {
    for (int i = 0; i < count; ++i) show(still);
  };
  const std::array<int, 2> size = output_.shown_size();
  const Presentation& around = output_.presentation;
  if (taken_ == 0) {
    const std::array<int, 2> part = {size[0] / eyes_, size[1]};
    if (frames_.card > 0) {
      repeat(side_by_side(card_picture(part, background_, around.card), eyes_), frames_.card);
    }
    if (frames_.fixation > 0) {
      const auto edge = static_cast<int>(std::lround(output_.scale * around.fixation_size));
      repeat(side_by_side(fixation_picture(part, background_, edge), eyes_), frames_.fixation);
    }
    if (frames_.blank_before > 0) repeat(blank_picture(size, background_), frames_.blank_before);
  }
  const double rising = frames_.fade_in > 0 ? (taken_ + 0.5) / frames_.fade_in : 1.0;
  const double sinking =
      frames_.fade_out > 0 ? (frames_.film - taken_ - 0.5) / frames_.fade_out : 1.0;
  const double share = std::min(rising, sinking);
  share < 1.0 ? show(faded(picture, share)) : show(picture);
  if (++taken_ == frames_.film && frames_.blank_after > 0) {
    repeat(blank_picture(size, background_), frames_.blank_after);
  }
}

render::Image8 Presenter::faded(const render::Image8& picture, double share) const {
  const std::array<std::uint8_t, 256> table = mixed_codes(background_, share);
  render::Image8 result = picture;
  for (std::uint8_t& channel : result.channels) channel = table[channel];
  return result;
}

std::string fade_fault(const Stimulus& film, int film_frames) {
  const Presentation& shown = film.output.presentation;
  const double seconds = film_frames / film.output.fps;
  const double fades = shown.fade_in + shown.fade_out;
  const double half_a_frame = 0.5 / film.output.fps;
  if (film.output.video.empty() || fades <= seconds + half_a_frame) return "";
  return fmt::format("the fades last {:.4g} s, but the film of \"{}\" only {:.4g} s", fades,
                     film.id, seconds);
}

}  // namespace mien::pipeline
