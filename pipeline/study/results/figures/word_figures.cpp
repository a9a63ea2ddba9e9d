#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t max_words = 6;  // of a stimulus
constexpr std::size_t words_across = 3;
constexpr std::size_t max_word_panels = 24;  // on a page

constexpr double words_margin = 18.0;
constexpr double words_header = 58.0;
constexpr double words_panel_width = 190.0;
constexpr double words_panel_gap = 16.0;
constexpr double word_width = 92.0;
constexpr double word_line = 14.0;
constexpr double words_panel_height = 26.0 + word_line * max_words;

/// The words of one stimulus, the most frequent first.
struct WordPanel {
  std::string stimulus;
  int respondents = 0;
  std::vector<WordFrequency> words;
  int others = 0;  ///< further words
};

std::vector<WordPanel> word_panels(const std::vector<WordFrequency>& counts,
                                   const std::string& item) {
  std::vector<WordPanel> panels;
  for (const WordFrequency& count : counts) {
    if (count.item != item) continue;
    if (panels.empty() || panels.back().stimulus != count.stimulus)
      panels.push_back({count.stimulus, count.respondents, {}});
    WordPanel& panel = panels.back();
    if (panel.words.size() < max_words) {
      panel.words.push_back(count);
    } else {
      ++panel.others;
    }
  }
  return panels;
}

/// Bars are shares of the participants who gave any word, on a common scale.
void draw_word_panel(Canvas& canvas, const Box& box, const WordPanel& panel) {
  const std::string note = fmt::format("n = {}", panel.respondents);
  const double note_width = canvas.text_width(note, {.size = 7.5}) + 8.0;
  canvas.text({box.x, box.y + 9.0}, panel.stimulus,
              {.size = 9.0, .bold = true, .max_width = box.width - note_width});
  canvas.text({box.right(), box.y + 9.0}, note,
              {.size = 7.5, .colour = quiet_ink, .align = Align::right});
  const double room = box.width - word_width - 26.0;
  for (std::size_t i = 0; i < panel.words.size(); ++i) {
    const WordFrequency& count = panel.words[i];
    const double y = box.y + 14.0 + word_line * static_cast<double>(i);
    canvas.text({box.x + word_width - 6.0, y + 9.5}, count.word,
                {.size = 8.0, .align = Align::right, .max_width = word_width - 6.0});
    const double length = room * count.people / std::max(1, panel.respondents);
    canvas.fill(Box{box.x + word_width, y + 2.0, length, word_line - 4.0}, created_colours.light);
    canvas.text({box.x + word_width + length + 4.0, y + 9.5}, std::to_string(count.people),
                {.size = 8.0, .bold = true});
  }
  if (panel.others == 0) return;
  canvas.text({box.x + word_width, box.y + words_panel_height - 5.0},
              fmt::format("and {} more", panel.others), {.size = 7.0, .colour = quiet_ink});
}

Plot words_plot(const std::string& title, const std::vector<WordPanel>& panels, bool simulated) {
  const std::size_t columns = words_across;
  const auto rows = static_cast<double>((panels.size() + columns - 1) / columns);
  const double width =
      2.0 * words_margin + columns * (words_panel_width + words_panel_gap) - words_panel_gap;
  const double height =
      2.0 * words_margin + words_header + rows * (words_panel_height + 10.0) - 10.0;
  return {title, width, height, [=](Canvas& canvas) {
            canvas.text({words_margin, words_margin + 12.0}, title,
                        {.size = 12.0, .bold = true, .max_width = width - 180.0});
            canvas.text({words_margin, words_margin + 27.0},
                        "Number of participants who gave each of the most frequent words; n: "
                        "participants who gave any",
                        {.size = 8.5, .colour = quiet_ink});
            for (std::size_t i = 0; i < panels.size(); ++i) {
              const auto column = static_cast<double>(i % columns);
              const auto row = static_cast<double>(i / columns);
              draw_word_panel(canvas,
                              {words_margin + column * (words_panel_width + words_panel_gap),
                               words_margin + words_header + row * (words_panel_height + 10.0),
                               words_panel_width, words_panel_height},
                              panels[i]);
            }
            if (simulated) draw_simulated_mark(canvas, {width - words_margin, words_margin - 2.0});
          }};
}

}  // namespace

void add_word_figures(const Results& results, std::vector<ResultFigure>& figures) {
  std::set<std::string> items;
  for (const WordFrequency& count : results.words) items.insert(count.item);
  for (const std::string& item : items) {
    const std::vector<WordPanel> panels = word_panels(results.words, item);
    for (std::size_t first = 0; first < panels.size(); first += max_word_panels) {
      const std::size_t end = std::min(panels.size(), first + max_word_panels);
      const std::vector<WordPanel> part(panels.begin() + static_cast<std::ptrdiff_t>(first),
                                        panels.begin() + static_cast<std::ptrdiff_t>(end));
      const std::string number =
          first > 0 ? fmt::format("-{}", first / max_word_panels + 1) : std::string();
      figures.push_back({"words-" + item + number, "words", "", "",
                         "Most frequent words for each video.",
                         words_plot("Words for " + item, part, results.answer_set.simulated)});
    }
  }
}

}  // namespace mien::pipeline
