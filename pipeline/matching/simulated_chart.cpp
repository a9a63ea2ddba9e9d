#include "pipeline/matching/simulated_chart.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

constexpr double page_width = 640.0;  // points
constexpr double page_height = 250.0;

/// One bar, in the panel's unit.
struct Bar {
  std::string name;
  double value = 0.0;
  double deviation = 0.0;
  Colour colour;
};

struct Panel {
  Box box;  ///< of the bars, without labels
  std::string title;
  double most = 1.0;
  std::string unit;
  double mark = 0.0;  ///< a line across; 0 for none
};

Colour colour_of(InterfaceKind kind) {
  switch (kind) {
    case InterfaceKind::adjectives:
      return target_colours.line;
    case InterfaceKind::features:
      return created_colours.line;
    case InterfaceKind::weights:
      break;
  }
  return reference_colours.line;
}

std::string way_of(const InterfaceSummary& s) {
  return s.step > 0.0 ? fmt::format("step {:g}", s.step) : "guess";
}

/// A round number not below `value`.
double round_limit(double value) {
  const double size = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-6))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * size >= value) return factor * size;
  }
  return 10.0 * size;
}

void draw_axis(Canvas& canvas, const Panel& panel) {
  const Box& box = panel.box;
  canvas.text({box.x - 26.0, box.y - 16.0}, panel.title, {.size = 9.0, .bold = true});
  for (int i = 0; i <= 4; ++i) {
    const double y = box.bottom() - box.height * i / 4;
    canvas.line({box.x, y}, {box.right(), y}, {.width = 0.5, .colour = hairline});
    canvas.text({box.x - 4.0, y + 2.6}, fmt::format("{:g}", panel.most * i / 4),
                {.size = 7.0, .colour = quiet_ink, .align = Align::right});
  }
  canvas.text({box.x - 4.0, box.y - 6.0}, panel.unit,
              {.size = 7.0, .colour = quiet_ink, .align = Align::right});
}

void draw_bars(Canvas& canvas, const Panel& panel, const std::vector<Bar>& bars) {
  draw_axis(canvas, panel);
  const Box& box = panel.box;
  const double pitch = box.width / static_cast<double>(bars.size());
  const auto y_of = [&](double value) {
    return box.bottom() - box.height * std::clamp(value / panel.most, 0.0, 1.0);
  };
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const Bar& bar = bars[i];
    const double middle = box.x + pitch * (static_cast<double>(i) + 0.5);
    const double top = y_of(bar.value);
    canvas.fill(Box{middle - 0.32 * pitch, top, 0.64 * pitch, box.bottom() - top}, bar.colour);
    if (bar.deviation > 0.0) {
      canvas.line({middle, y_of(bar.value - bar.deviation)},
                  {middle, y_of(bar.value + bar.deviation)}, {.width = 0.8});
    }
    canvas.text({middle, box.bottom() + 9.5}, bar.name,
                {.size = 6.0, .colour = quiet_ink, .align = Align::centre, .max_width = pitch});
  }
  if (panel.mark > 0.0) {
    canvas.line({box.x, y_of(panel.mark)}, {box.right(), y_of(panel.mark)},
                {.width = 0.8, .colour = ink, .dashed = true});
  }
}

void draw_legend(Canvas& canvas, const std::vector<InterfaceSummary>& summaries, Point at) {
  std::vector<InterfaceKind> shown;
  for (const InterfaceSummary& s : summaries) {
    if (std::find(shown.begin(), shown.end(), s.kind) != shown.end()) continue;
    shown.push_back(s.kind);
    canvas.fill(Box{at.x, at.y - 6.5, 8.0, 8.0}, colour_of(s.kind), 1.5);
    const Box word = canvas.text({at.x + 12.0, at.y}, name_of(s.kind), {.size = 8.0});
    at.x = word.right() + 18.0;
  }
}

void draw_mark(Canvas& canvas) {
  const std::string words = "Simulated: no person took part  模擬";
  const TextStyle style = {.size = 8.5, .colour = caution_ink, .bold = true};
  const double width = canvas.text_width(words, style) + 18.0;
  const Box pill = {page_width - 18.0 - width, 10.0, width, 17.0};
  canvas.fill(pill, caution, 8.5);
  canvas.text({pill.x + 9.0, pill.y + 11.7}, words, style);
}

void draw(Canvas& canvas, const std::vector<InterfaceSummary>& summaries, double threshold_m) {
  canvas.text({18.0, 23.0}, "How near each interface comes to its targets",
              {.size = 12.0, .bold = true});
  draw_mark(canvas);
  draw_legend(canvas, summaries, {18.0, 40.0});
  std::vector<Bar> distances, successes, failures;
  double most = threshold_m;
  for (const InterfaceSummary& s : summaries) {
    const Colour colour = colour_of(s.kind);
    distances.push_back({way_of(s), s.mean_first, s.sd_first, colour});
    most = std::max(most, s.mean_first + s.sd_first);
    if (s.step > 0.0) continue;
    successes.push_back({name_of(s.kind), 100.0 * s.first_success, 0.0, colour});
    failures.push_back({name_of(s.kind), 100.0 * s.failure, 0.0, colour});
  }
  draw_bars(canvas,
            {{44.0, 78.0, 300.0, 140.0},
             "D of nearest settings and first guesses, ±1 SD",
             round_limit(most),
             "m",
             threshold_m},
            distances);
  if (successes.empty()) return;
  draw_bars(canvas, {{388.0, 78.0, 95.0, 140.0}, "First guesses that match", 100.0, "%", 0.0},
            successes);
  draw_bars(canvas, {{527.0, 78.0, 95.0, 140.0}, "Never matched", 100.0, "%", 0.0}, failures);
}

}  // namespace

Plot simulated_chart(const std::vector<InterfaceSummary>& summaries, double threshold_m) {
  return {"Interfaces, simulated", page_width, page_height,
          [summaries, threshold_m](Canvas& canvas) { draw(canvas, summaries, threshold_m); }};
}

}  // namespace mien::pipeline
