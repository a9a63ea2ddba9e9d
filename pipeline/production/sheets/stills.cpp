#include "pipeline/production/sheets/stills.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "render/image/resize.h"

namespace mien::pipeline {

namespace {

constexpr double pixels_per_point = 2.0;
constexpr double stills_margin = 24.0;
constexpr double stills_header = 34.0;
constexpr double stills_footer = 14.0;
constexpr double gap = 8.0;
constexpr double caption_height = 16.0;
constexpr double rim = 0.25;
constexpr double least_width = 220.0;  // of what is printed: the title needs room

/// The layout of the page, in points.
class Page {
 public:
  explicit Page(const StillsContent& content)
      : columns_(std::min(content.columns, static_cast<int>(content.stills.size()))) {
    int width = still_width;
    for (const Still& still : content.stills) width = std::min(width, still.picture.width);
    for (const Still& still : content.stills) {
      const double shape = static_cast<double>(still.picture.height) / still.picture.width;
      const int height = std::max(1, static_cast<int>(std::lround(shape * width)));
      // The filter would soften what has its size already.
      pictures_.push_back(width == still.picture.width
                              ? still.picture
                              : render::resized(still.picture, width, height));
      tallest_ = std::max(tallest_, height);
    }
    cell_ = {stills_margin, stills_margin + stills_header, width / pixels_per_point,
             tallest_ / pixels_per_point};
  }

  double width() const {
    return 2.0 * stills_margin + std::max(least_width, columns_ * (cell_.width + gap) - gap);
  }

  double height() const {
    const int rows = (static_cast<int>(pictures_.size()) + columns_ - 1) / columns_;
    return 2.0 * stills_margin + stills_header + rows * row_height() - gap + stills_footer;
  }

  const render::Image8& picture(std::size_t still) const { return pictures_[still]; }

  /// The box of one picture, centred in its cell but on whole pixels.
  Box box(std::size_t still) const {
    const int place = static_cast<int>(still);
    const int above = (tallest_ - pictures_[still].height) / 2;
    return {cell_.x + place % columns_ * (cell_.width + gap),
            cell_.y + place / columns_ * row_height() + above / pixels_per_point, cell_.width,
            pictures_[still].height / pixels_per_point};
  }

  Point caption(std::size_t still) const {
    const Box shown = box(still);
    return {shown.x + 0.5 * shown.width,
            cell_.bottom() + static_cast<int>(still) / columns_ * row_height() + 11.0};
  }

 private:
  double row_height() const { return cell_.height + caption_height + gap; }

  int columns_;
  int tallest_ = 0;  // pixels
  std::vector<render::Image8> pictures_;
  Box cell_;  // the first picture's place
};

std::string drawn(Canvas& canvas, const StillsContent& content, const Page& page) {
  const double baseline = stills_margin + 14.0;
  const double width = page.width() - 2.0 * stills_margin;
  const Box title = canvas.text({stills_margin, baseline}, content.title,
                                {.size = 16.0, .bold = true, .max_width = width});
  const double beside = title.right() + 10.0;
  if (beside < stills_margin + 0.8 * width) {
    canvas.text({beside, baseline}, content.study,
                {.size = 10.0, .colour = quiet_ink, .max_width = stills_margin + width - beside});
  }
  for (std::size_t i = 0; i < content.stills.size(); ++i) {
    const Box box = page.box(i);
    // A rim around it, for pictures as white as the page.
    canvas.outline({box.x - rim, box.y - rim, box.width + 2.0 * rim, box.height + 2.0 * rim},
                   {.width = 2.0 * rim, .colour = hairline});
    canvas.picture(box, page.picture(i));
    canvas.text(page.caption(i), content.stills[i].id,
                {.size = 8.0, .align = Align::centre, .max_width = box.width});
  }
  std::string facts = fmt::format("middle frame of each of {} films", content.stills.size());
  for (const auto& [name, value] : content.provenance) facts += "  ·  " + name + " " + value;
  canvas.text({stills_margin, page.height() - stills_margin}, facts,
              {.size = 7.0, .colour = quiet_ink, .max_width = width});
  return canvas.finish();
}

}  // namespace

std::string stills_as_pdf(const StillsContent& content) {
  const Page page(content);
  return drawn(*Canvas::pdf(page.width(), page.height(), content.title), content, page);
}

std::string stills_as_png(const StillsContent& content) {
  const Page page(content);
  const int wide = static_cast<int>(std::lround(page.width() * pixels_per_point));
  return drawn(*Canvas::png(wide / pixels_per_point, page.height(), wide), content, page);
}

}  // namespace mien::pipeline
