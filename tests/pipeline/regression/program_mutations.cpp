#include <algorithm>
#include <cmath>

#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/mutations.h"
#include "render/image/image_io.h"

namespace mien::test {

namespace {

using nlohmann::json;
using pipeline::Cause;
using pipeline::StimulusFacts;
using pipeline::Verdict;

/// Where a picture of the baseline is drawn otherwise, and by how much.
struct Bias {
  float factor = 1.0f;  ///< of the light
  double share = 1.0;   ///< of the picture, from the left
  bool only_the_red = false;
};

/// The approved pictures and blocks as a program with that bias would have drawn them.
void draw_otherwise(ChangedStudy& study, const std::string& id, const Bias& bias) {
  StimulusFacts& facts = study.approved(id);
  const std::size_t channels = bias.only_the_red ? 1 : 3;
  for (pipeline::KeyFrame& key : facts.key_frames) {
    const auto file = study.baseline.picture_file(id, key.frame);
    render::Image8 picture = render::read_png8(file);
    const int until = static_cast<int>(bias.share * picture.width);
    const float on_display = std::pow(bias.factor, 1.0f / 2.2f);
    for (std::size_t i = 0; i < picture.channels.size(); ++i) {
      const bool is_in = static_cast<int>(i / 3) % picture.width < until && i % 3 < channels;
      if (!is_in) continue;
      const float value = static_cast<float>(picture.channels[i]) * on_display;
      picture.channels[i] = static_cast<std::uint8_t>(std::clamp(value + 0.5f, 0.0f, 255.0f));
    }
    render::write_png(file, picture);
    key.pixels = pipeline::hash_of_pixels(picture);
    const auto blocks_file = study.baseline.blocks_file(id, key.frame);
    pipeline::BlockStatistics blocks = pipeline::read_blocks(blocks_file);
    for (std::size_t i = 0; i < blocks.count(); ++i) {
      const auto column = static_cast<int>(i / 3) % blocks.columns;
      const bool is_in = column * pipeline::block_pixels < until && i % 3 < channels;
      if (is_in) blocks.mean[i] *= bias.factor;
    }
    pipeline::write_blocks(blocks_file, blocks);
  }
}

Mutation of_renderer(const std::string& name, const std::string& id, const Bias& bias) {
  return {"renderer: " + name,
          id,
          Cause::renderer,
          "mien ",
          [=](ChangedStudy& study) {
            draw_otherwise(study, id, bias);
            study.approved(id).origin.film_code = "feedc0de";
          },
          Verdict::differs};
}

Mutation of_library(const std::string& library, const std::string& id, const Bias& bias) {
  return {"environment: " + library + " with other pictures",
          id,
          Cause::environment,
          library + " 0.0.1 → ",
          [=](ChangedStudy& study) {
            draw_otherwise(study, id, bias);
            study.approved(id).origin.libraries[library] = "0.0.1";
          },
          Verdict::differs};
}

/// A program that makes another motion of what was approved: what it made is approved, as that
/// which was asked for.
void make_otherwise(ChangedStudy& study, const std::string& id, const std::string& patch) {
  const ChangedStudy as_it_is = study;
  const StimulusFacts facts = study.approved(id);
  study.stimulus(id).merge_patch(json::parse(patch));
  study.baseline = approved_study().approved(study, study.folder / "baselines" / "otherwise");
  study.manifest = as_it_is.manifest;
  StimulusFacts& otherwise = study.approved(id);
  otherwise.settings = facts.settings;
  std::filesystem::copy(as_it_is.baseline.folder / "editions" / facts.edition,
                        study.baseline.folder / "editions" / facts.edition,
                        std::filesystem::copy_options::recursive);
  for (StimulusFacts& one : study.baseline.stimuli) one.edition = facts.edition;
}

Mutation of_synthesis(const std::string& id, const std::string& patch) {
  return {"synthesis: as if by " + patch,
          id,
          Cause::synthesis,
          "mien ",
          [=](ChangedStudy& study) {
            make_otherwise(study, id, patch);
            study.approved(id).origin.motion_code = "feedc0de";
          },
          Verdict::differs};
}

}  // namespace

std::vector<Mutation> program_mutations() {
  std::vector<Mutation> all = {
      of_renderer("everything 1 % lighter", "tinted", {.factor = 1.01f}),
      of_renderer("a third 20 % darker", "blend", {.factor = 0.8f, .share = 0.34}),
      of_renderer("redder", "someone", {.factor = 1.1f, .only_the_red = true}),
      of_library("Embree", "blend", {.factor = 1.05f}),
      of_library("OpenImageIO", "tinted", {.factor = 0.9f, .share = 0.5}),
      of_synthesis("blend", R"({"weights": {"normal": 0.62, "proud": 0.38}})"),
      of_synthesis("wish", R"({"interpolation": {"method": "knn"}})"),
  };
  all.push_back({"environment: a processor that makes other motions", "blend", Cause::environment,
                 "processor",
                 [](ChangedStudy& study) {
                   make_otherwise(study, "blend",
                                  R"({"weights": {"normal": 0.65, "proud": 0.35}})");
                   study.approved("blend").origin.processor = "another";
                 },
                 Verdict::differs});
  all.push_back({"pictures that nothing explains", "styled", Cause::unknown, "the same program",
                 [](ChangedStudy& study) {
                   draw_otherwise(study, "styled", {.factor = 1.2f, .share = 0.5});
                   study.audits = 1.0;  // nothing else would have it drawn
                 },
                 Verdict::differs});
  return all;
}

std::vector<Mutation> video_mutations() {
  const auto of_video = [](const std::string& name, Cause cause, const std::string& root,
                           Verdict verdict, const std::function<void(ChangedStudy&)>& change) {
    return Mutation{"video: " + name,
                    "wish",
                    cause,
                    root,
                    [=](ChangedStudy& study) {
                      study.videos.at("wish").front().hash = "another";
                      change(study);
                    },
                    verdict};
  };
  const auto show_frames = [](ChangedStudy& study, const char* before, const char* now) {
    study.approved("wish").videos.front().record.frames_hash = before;
    study.videos.at("wish").front().record.frames_hash = now;
  };
  const auto present = [](ChangedStudy& study, const char* option, const nlohmann::json& value) {
    study.stimulus("wish")["output"]["presentation"][option] = value;
  };
  return {
      of_video(
          "another quality of the codec", Cause::encoder, "the encoder", Verdict::differs,
          [](ChangedStudy& study) { study.videos.at("wish").front().record.worst_psnr_db = 37.0; }),
      of_video("other bytes of the same worth", Cause::encoder, "the encoder", Verdict::alike,
               [](ChangedStudy&) {}),
      of_video("other bytes of the same frames", Cause::encoder, "the encoder", Verdict::alike,
               [=](ChangedStudy& study) { show_frames(study, "1", "1"); }),
      of_video("a dropped frame", Cause::encoder, "the encoder", Verdict::differs,
               [](ChangedStudy& study) { study.videos.at("wish").front().record.frames = 9; }),
      of_video(
          "another FFmpeg", Cause::encoder, "FFmpeg 0.0.1", Verdict::alike,
          [](ChangedStudy& study) { study.approved("wish").origin.libraries["FFmpeg"] = "0.0.1"; }),
      of_video("a blank before it", Cause::presentation, "output.presentation", Verdict::differs,
               [=](ChangedStudy& study) {
                 present(study, "blank_before", 0.5);
                 study.videos.at("wish").front().record.frames = 15;
               }),
      of_video("another background", Cause::presentation, "output.presentation.background",
               Verdict::differs,
               [=](ChangedStudy& study) {
                 present(study, "background", 0.25);
                 show_frames(study, "1", "2");
               }),
      of_video("a fade, with frames that are not known", Cause::presentation,
               "output.presentation.fade_in", Verdict::differs,
               [=](ChangedStudy& study) { present(study, "fade_in", 0.25); }),
      of_video("other frames that nothing explains", Cause::unknown, "the same program",
               Verdict::differs, [=](ChangedStudy& study) { show_frames(study, "1", "2"); }),
      of_video("none at all", Cause::presentation, "output.video", Verdict::differs,
               [](ChangedStudy& study) {
                 study.stimulus("wish")["output"]["video"] = nlohmann::json::array();
                 study.videos.at("wish").clear();
               }),
  };
}

}  // namespace mien::test
