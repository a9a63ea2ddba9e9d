#include "pipeline/production/sheets/sheet_task.h"

#include <stdexcept>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/sheets/sheet.h"
#include "pipeline/production/sheets/sheet_content.h"
#include "pipeline/tasks/code_identity.h"
#include "render/image/image_io.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double sheet_cost_seconds = 2.0;

void verify_pdf(const fs::path& file) {
  const std::string bytes = read_file(file);
  if (bytes.starts_with("%PDF-") && bytes.find("%%EOF", bytes.size() - 16) != std::string::npos) {
    return;
  }
  throw std::runtime_error(file.string() + " is not a complete PDF");
}

}  // namespace

void add_printed(KeyBuilder& key, const Manifest& manifest) {
  key.add("study", manifest.study);
  for (const auto& [name, value] : provenance_of(manifest)) key.add(name, value);
}

std::vector<Product> sheet_products(const Sheet& sheet) {
  return {{"sheets/" + sheet.id + ".pdf", {}}, {"sheets/" + sheet.id + ".png", {}}};
}

void put_sheet(TaskRun& run, const std::string& pdf, const std::string& png) {
  run.put_text(0, pdf, verify_pdf);
  run.put_text(1, png, render::check_image);
}

Task sheet_task(const Sheet& sheet, const Manifest& manifest, const SharedDeterminants& shared,
                Motions& motions) {
  Task task;
  task.id = "sheet:" + sheet.id;
  task.kind = "sheet";
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", sheet_code());
  add_printed(task.determinants, manifest);
  const bool is_gallery = !sheet.gallery.empty();
  task.determinants.add("kind of sheet", is_gallery ? "gallery" : "comparison")
      .add("names", word_of(name_language_words, name_language(manifest)));
  bool uses_examples = false;
  for (const std::string& name : motions_on(sheet)) {
    task.determinants.add("motion", name).add("from", origin_of(name, motions));
    const Stimulus* stimulus = motions.stimulus(name);
    if (stimulus != nullptr) {
      if (is_gallery) task.determinants.add("role", name_of(stimulus->role));  // its colour
      task.inputs.push_back("motion:" + name);
    }
    uses_examples = uses_examples || stimulus == nullptr || is_blend(*stimulus);
  }
  if (uses_examples) {
    task.determinants.add("repertoire", shared.repertoire).add("made at", manifest.output.fps);
    add_interpolation(task.determinants, manifest.interpolation);
  }
  task.products = sheet_products(sheet);
  task.cost_seconds = sheet_cost_seconds;
  task.make = [&sheet, &manifest, &motions](TaskRun& run) {
    if (sheet.gallery.empty()) {
      const SheetContent content = sheet_content(sheet, manifest, motions);
      put_sheet(run, sheet_as_pdf(content), sheet_as_png(content));
    } else {
      const GalleryContent content = gallery_content(sheet, manifest, motions);
      put_sheet(run, gallery_as_pdf(content), gallery_as_png(content));
    }
  };
  return task;
}

}  // namespace mien::pipeline
