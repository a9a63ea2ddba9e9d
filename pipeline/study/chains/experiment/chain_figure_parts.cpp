#include "pipeline/study/chains/experiment/chain_figure_parts.h"

#include <algorithm>

#include "pipeline/base/drawing/palette.h"

namespace mien::pipeline {

void draw_figure_header(Canvas& canvas, const ChainResults& results, const std::string& title,
                        const std::string& words, double width) {
  canvas.text({figure_margin, figure_margin + 12.0}, title, {.size = 12.0, .bold = true});
  canvas.text({figure_margin, figure_margin + 27.0}, words, {.size = 8.5, .colour = quiet_ink});
  if (results.simulated)
    draw_simulated_mark(canvas, {width - figure_margin, figure_margin}, "Simulated answers");
}

double share_of(const DimensionRange& range, double value) {
  return std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
}

}  // namespace mien::pipeline
