#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "render/image/image.h"

namespace mien::pipeline {

/// A presentation in whole frames. Neither fade lasts longer than the film.
struct PresentationFrames {
  int card = 0;
  int fixation = 0;
  int blank_before = 0;
  int film = 0;
  int held = 0;  ///< by which the film's last picture is shown longer, with a longer sound
  int blank_after = 0;
  int fade_in = 0;   ///< how many of the film's frames the fade-in covers
  int fade_out = 0;  ///< how many of the last frames, held ones included, the fade-out covers

  int before() const { return card + fixation + blank_before; }
  int all() const { return before() + film + held + blank_after; }
};

/// Returns the presentation with its durations rounded to the nearest whole number of frames.
/// `fps`: frames per second.
PresentationFrames frames_of(const Presentation& presentation, double fps, int film_frames,
                             int held_frames = 0);

/// Returns what is wrong if videos are to be written and both fades together last more than half a
/// frame longer than a film of `film_frames` frames; otherwise empty.
std::string fade_fault(const Stimulus& film, int film_frames);

inline constexpr char fade_remedy[] = "make them shorter, or show more cycles";

/// Shows a film with the pictures before and after it.
///
/// Fades mix film and background in linear light: frame n (from 0) of the m frames of a fade-in has
/// the weight (n + ½) / m, and the background the rest; a fade-out is the reverse. Neither the card
/// nor the cross fades.
class Presenter {
 public:
  using Show = std::function<void(const render::Image8& picture)>;

  /// Each of the `eyes` gets its own card and cross, in its part of the picture.
  Presenter(const Output& output, int film_frames, int eyes = 1, int held_frames = 0);

  const PresentationFrames& frames() const { return frames_; }

  /// Takes the film's next frame and shows it. The first frame is preceded by the pictures that are
  /// shown before the film, and the last frame is held and followed by those that are shown after
  /// it.
  void take(const render::Image8& picture, const Show& show);

 private:
  void show_faded(const render::Image8& picture, int number, const Show& show) const;
  render::Image8 faded(const render::Image8& picture, double share) const;

  Output output_;
  int eyes_;
  PresentationFrames frames_;
  std::uint8_t background_;
  int taken_ = 0;
};

/// Returns a blank picture in an 8-bit grey, as shown before and after a film.
render::Image8 blank_picture(std::array<int, 2> size, std::uint8_t grey);
/// Returns a cross with a width and height of `edge` pixels and a thickness of a ninth of that, but
/// at least 2 pixels (each is one less if it cannot be centred otherwise). The cross is black on a
/// grey above 127, otherwise white.
render::Image8 fixation_picture(std::array<int, 2> size, std::uint8_t grey, int edge);
/// Returns a picture of centred lines of text. The font is as large as fits, at most an 18th of the
/// picture's height.
render::Image8 card_picture(std::array<int, 2> size, std::uint8_t grey, const std::string& text);

}  // namespace mien::pipeline
