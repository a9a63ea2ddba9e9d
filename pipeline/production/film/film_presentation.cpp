#include "pipeline/production/film/film_presentation.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
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

/// The picture repeated side by side `times` times.
render::Image8 side_by_side(const render::Image8& one, int times) {
  render::Image8 all(times * one.width, one.height);
  for (int y = 0; y < one.height; ++y) {
    for (int k = 0; k < times; ++k) {
      std::copy_n(one.at(0, y), 3 * one.width, all.at(k * one.width, y));
    }
  }
  return all;
}

bool is_light(std::uint8_t grey) { return grey > 127; }

}  // namespace

PresentationFrames frames_of(const Presentation& presentation, double fps, int film_frames,
                             int held_frames) {
  PresentationFrames frames;
  if (!presentation.card.empty()) frames.card = whole_frames(presentation.card_seconds, fps);
  frames.fixation = whole_frames(presentation.fixation_seconds, fps);
  frames.blank_before = whole_frames(presentation.blank_before, fps);
  frames.film = film_frames;
  frames.held = held_frames;
  frames.blank_after = whole_frames(presentation.blank_after, fps);
  frames.fade_in = std::min(film_frames, whole_frames(presentation.fade_in, fps));
  frames.fade_out = std::min(film_frames, whole_frames(presentation.fade_out, fps));
  return frames;
}

Presenter::Presenter(const Output& output, int film_frames, int eyes, int held_frames)
    : output_(output),
      eyes_(eyes),
      frames_(frames_of(output.presentation, output.fps, film_frames, held_frames)),
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
  show_faded(picture, taken_, show);
  if (++taken_ < frames_.film) return;
  for (int held = 0; held < frames_.held; ++held) show_faded(picture, taken_ + held, show);
  if (frames_.blank_after > 0) repeat(blank_picture(size, background_), frames_.blank_after);
}

void Presenter::show_faded(const render::Image8& picture, int number, const Show& show) const {
  const int count = frames_.film + frames_.held;
  const double rising = frames_.fade_in > 0 ? (number + 0.5) / frames_.fade_in : 1.0;
  const double sinking = frames_.fade_out > 0 ? (count - number - 0.5) / frames_.fade_out : 1.0;
  const double share = std::min(rising, sinking);
  share < 1.0 ? show(faded(picture, share)) : show(picture);
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

render::Image8 blank_picture(std::array<int, 2> size, std::uint8_t grey) {
  render::Image8 picture(size[0], size[1]);
  std::fill(picture.channels.begin(), picture.channels.end(), grey);
  return picture;
}

render::Image8 fixation_picture(std::array<int, 2> size, std::uint8_t grey, int edge) {
  render::Image8 picture = blank_picture(size, grey);
  const std::uint8_t shade = is_light(grey) ? 0 : 255;
  // As many pixels on either side of the middle, which lies between pixels in even sizes.
  const auto bar = [&](int length, int extent) {
    length = std::min(length, extent);
    return length - (extent - length) % 2;
  };
  const auto fill = [&](int across, int down) {
    const int width = std::max(1, bar(across, size[0]));
    const int height = std::max(1, bar(down, size[1]));
    const int left = (size[0] - width) / 2;
    const int top = (size[1] - height) / 2;
    for (int y = top; y < top + height; ++y) std::fill_n(picture.at(left, y), 3 * width, shade);
  };
  const int thick = std::max(2, (edge + 4) / 9);
  fill(edge, thick);
  fill(thick, edge);
  return picture;
}

render::Image8 card_picture(std::array<int, 2> size, std::uint8_t grey, const std::string& text) {
  const double width = size[0];
  const double height = size[1];
  const auto canvas = Canvas::png(width, height, size[0]);
  const double level = grey / 255.0;
  canvas->fill(Box{0, 0, width, height}, Colour{level, level, level});
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const double shade = is_light(grey) ? 0.0 : 1.0;
  TextStyle style{.size = height / 18.0, .colour = {shade, shade, shade}, .align = Align::centre};
  constexpr double spacing = 1.5;
  double widest = 0.0;
  for (const std::string& line : lines) {
    widest = std::max(widest, canvas->text_width(line, style));
  }
  const double tallest = spacing * style.size * static_cast<double>(lines.size());
  style.size *= std::min({1.0, 0.9 * width / std::max(widest, 1.0), 0.9 * height / tallest});
  const double step = spacing * style.size;
  // The middle of a line of text lies about a third of its size above its baseline.
  double baseline =
      0.5 * (height - step * static_cast<double>(lines.size() - 1)) + 0.35 * style.size;
  for (const std::string& line : lines) {
    canvas->text({0.5 * width, baseline}, line, style);
    baseline += step;
  }
  return canvas->finish_picture();
}

}  // namespace mien::pipeline
