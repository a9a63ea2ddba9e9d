#include "pipeline/production/film/film_waveform.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"

namespace mien::pipeline {

namespace {

constexpr int picture_width = 480;
constexpr int picture_height = 116;
constexpr int wave_height = 80;  ///< full scale, from the top
constexpr int stretches = 480;

/// One closed outline: the largest samples to the right, the smallest back to the left.
std::string outline(const render::Sound& sound) {
  const std::vector<render::SampleRange> ranges = render::waveform(sound, stretches);
  const auto point = [](int stretch, float sample) {
    return fmt::format(" {:.1f},{:.1f}", (stretch + 0.5) * picture_width / stretches,
                       0.5 * wave_height * (1.0 - static_cast<double>(sample)));
  };
  std::string points;
  for (int i = 0; i < stretches; ++i) points += point(i, ranges[static_cast<std::size_t>(i)].most);
  for (int i = stretches - 1; i >= 0; --i)
    points += point(i, ranges[static_cast<std::size_t>(i)].least);
  return points;
}

/// Of the first line: what is heard.
std::string caption(const SoundRecord& record, double seconds) {
  std::string text = fmt::format("{}, {:.2f} s", record.file, seconds);
  if (record.loudness_lufs) text += fmt::format(", {:.1f} LUFS", *record.loudness_lufs);
  if (record.true_peak_dbtp) text += fmt::format(", true peak {:.1f} dBTP", *record.true_peak_dbtp);
  return text;
}

/// Of the second line: how sound and film were made equally long.
std::string fitting(const SoundRecord& record) {
  if (record.cut_s > 0.0) return fmt::format("the sound is cut by {:.2f} s", record.cut_s);
  if (record.silence_s > 0.0)
    return fmt::format("followed by {:.2f} s of silence", record.silence_s);
  if (record.held_frames > 0)
    return fmt::format("the last picture is held for {} frame{}", record.held_frames,
                       record.held_frames == 1 ? "" : "s");
  return "";
}

}  // namespace

std::string waveform_path(const std::string& stimulus) {
  return "sheets/sound/" + stimulus + ".svg";
}

std::string waveform_svg(const FilmSound& sound, const PresentationFrames& frames, double fps) {
  const double all = frames.all();
  const auto line = [&](int frame, const char* title) {
    const double x = std::round(10.0 * frame / all * picture_width) / 10.0;
    return fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"{1}\" stroke=\"#b23c30\" "
        "stroke-dasharray=\"4 3\"><title>{2}</title></line>\n",
        x, wave_height, title);
  };
  std::string lines;
  if (frames.before() > 0) lines += line(frames.before(), "the film begins");
  if (frames.held > 0)
    lines += line(frames.before() + frames.film, "the last picture is held from here");
  if (frames.blank_after > 0)
    lines += line(frames.before() + frames.film + frames.held, "the film ends");
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
      "<line x1=\"0\" x2=\"{0}\" y1=\"{2}\" y2=\"{2}\" stroke=\"#d6dbe1\"/>\n"
      "<polygon points=\"{3}\" fill=\"#2a62b8\"/>\n{4}"
      "<g font-family=\"sans-serif\" font-size=\"14\" fill=\"#1d2126\"><text x=\"4\" "
      "y=\"{5}\">{6}</text>\n<text x=\"4\" y=\"{7}\">{8}</text></g>\n</svg>\n",
      picture_width, picture_height, wave_height / 2, outline(sound.sound).substr(1), lines,
      wave_height + 15, html_escaped(caption(sound.record, all / fps)), wave_height + 32,
      html_escaped(fitting(sound.record)));
}

}  // namespace mien::pipeline
