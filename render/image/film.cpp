#include "render/image/film.h"

namespace mien::render {

Film cut_out(const Film& film, const Window& window) {
  Film cut;
  cut.width = window.width;
  cut.height = window.height;
  cut.channels = cut_out(film.channels, film.width, window, 3);
  return cut;
}

}  // namespace mien::render
