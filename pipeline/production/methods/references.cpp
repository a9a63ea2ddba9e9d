#include "pipeline/production/methods/references.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

constexpr Reference references[] = {
    {"shepard1968", "Shepard 1968",
     R"(  author = {Shepard, Donald},
  title = {A Two-Dimensional Interpolation Function for Irregularly-Spaced Data},
  booktitle = {Proceedings of the 23rd ACM National Conference},
  pages = {517--524},
  year = {1968},
  doi = {10.1145/800186.810616})",
     "inproceedings"},
    {"fritsch1980", "Fritsch and Carlson 1980",
     R"(  author = {Fritsch, Frederick N. and Carlson, Ralph E.},
  title = {Monotone Piecewise Cubic Interpolation},
  journal = {SIAM Journal on Numerical Analysis},
  volume = {17},
  number = {2},
  pages = {238--246},
  year = {1980},
  doi = {10.1137/0717021})"},
    {"bruderlin1995", "Bruderlin and Williams 1995",
     R"(  author = {Bruderlin, Armin and Williams, Lance},
  title = {Motion Signal Processing},
  booktitle = {Proceedings of SIGGRAPH 95},
  pages = {97--104},
  year = {1995})",
     "inproceedings"},
    {"unuma1995", "Unuma, Anjyo and Takeuchi 1995",
     R"(  author = {Unuma, Munetoshi and Anjyo, Ken and Takeuchi, Ryozo},
  title = {Fourier Principles for Emotion-based Human Figure Animation},
  booktitle = {Proceedings of SIGGRAPH 95},
  pages = {91--96},
  year = {1995})",
     "inproceedings"},
    {"witkin1995", "Witkin and Popović 1995",
     R"(  author = {Witkin, Andrew and Popovi{\'c}, Zoran},
  title = {Motion Warping},
  booktitle = {Proceedings of SIGGRAPH 95},
  pages = {105--108},
  year = {1995},
  doi = {10.1145/218380.218422})",
     "inproceedings"},
    {"amaya1996", "Amaya, Bruderlin and Calvert 1996",
     R"(  author = {Amaya, Kenji and Bruderlin, Armin and Calvert, Tom},
  title = {Emotion from Motion},
  booktitle = {Proceedings of Graphics Interface '96},
  pages = {222--229},
  year = {1996},
  doi = {10.20380/GI1996.26})",
     "inproceedings"},
    {"wiley1997", "Wiley and Hahn 1997",
     R"(  author = {Wiley, Douglas J. and Hahn, James K.},
  title = {Interpolation Synthesis of Articulated Figure Motion},
  journal = {IEEE Computer Graphics and Applications},
  volume = {17},
  number = {6},
  pages = {39--45},
  year = {1997})"},
    {"rose1998", "Rose, Cohen and Bodenheimer 1998",
     R"(  author = {Rose, Charles and Cohen, Michael F. and Bodenheimer, Bobby},
  title = {Verbs and Adverbs: Multidimensional Motion Interpolation},
  journal = {IEEE Computer Graphics and Applications},
  volume = {18},
  number = {5},
  pages = {32--40},
  year = {1998},
  doi = {10.1109/38.708559})"},
    {"sloan2001", "Sloan, Rose and Cohen 2001",
     R"(  author = {Sloan, Peter-Pike J. and Rose, Charles F. and Cohen, Michael F.},
  title = {Shape by Example},
  booktitle = {Proceedings of the 2001 Symposium on Interactive 3D Graphics},
  pages = {135--143},
  year = {2001})",
     "inproceedings"},
    {"huang2010", "Huang and Kallmann 2010",
     R"(  author = {Huang, Yazhou and Kallmann, Marcelo},
  title = {Motion Parameterization with Inverse Blending},
  booktitle = {Motion in Games},
  series = {Lecture Notes in Computer Science},
  volume = {6459},
  year = {2010})",
     "inproceedings"},
    {"kovar2002", "Kovar, Schreiner and Gleicher 2002",
     R"(  author = {Kovar, Lucas and Schreiner, John and Gleicher, Michael},
  title = {Footskate Cleanup for Motion Capture Editing},
  booktitle = {Proceedings of the 2002 ACM SIGGRAPH/Eurographics Symposium on Computer Animation},
  pages = {97--104},
  year = {2002},
  doi = {10.1145/545261.545277})",
     "inproceedings"},
    {"kovar2004", "Kovar and Gleicher 2004",
     R"(  author = {Kovar, Lucas and Gleicher, Michael},
  title = {Automated Extraction and Parameterization of Motions in Large Data Sets},
  journal = {ACM Transactions on Graphics},
  volume = {23},
  number = {3},
  pages = {559--568},
  year = {2004})"},
    {"hsu2005", "Hsu, Pulli and Popović 2005",
     R"(  author = {Hsu, Eugene and Pulli, Kari and Popovi{\'c}, Jovan},
  title = {Style Translation for Human Motion},
  journal = {ACM Transactions on Graphics},
  volume = {24},
  number = {3},
  pages = {1082--1089},
  year = {2005})"},
    {"mukai2005", "Mukai and Kuriyama 2005",
     R"(  author = {Mukai, Tomohiko and Kuriyama, Shigeru},
  title = {Geostatistical Motion Interpolation},
  journal = {ACM Transactions on Graphics},
  volume = {24},
  number = {3},
  pages = {1062--1070},
  year = {2005},
  doi = {10.1145/1073204.1073313})"},
    {"shapiro2006", "Shapiro, Cao and Faloutsos 2006",
     R"(  author = {Shapiro, Ari and Cao, Yong and Faloutsos, Petros},
  title = {Style Components},
  booktitle = {Proceedings of Graphics Interface 2006},
  pages = {33--39},
  year = {2006})",
     "inproceedings"},
    {"markley2007", "Markley, Cheng, Crassidis and Oshman 2007",
     R"(  author = {Markley, F. Landis and Cheng, Yang and Crassidis, John L. and Oshman, Yaakov},
  title = {Averaging Quaternions},
  journal = {Journal of Guidance, Control, and Dynamics},
  volume = {30},
  number = {4},
  pages = {1193--1197},
  year = {2007},
  doi = {10.2514/1.28949})"},
    {"zeni2008", "Zeni, Richards and Higginson 2008",
     R"(  author = {Zeni, Jr., J. A. and Richards, J. G. and Higginson, J. S.},
  title = {Two simple methods for determining gait events during treadmill and overground walking using kinematic data},
  journal = {Gait \& Posture},
  volume = {27},
  number = {4},
  pages = {710--714},
  year = {2008},
  doi = {10.1016/j.gaitpost.2007.07.007})"},
    {"min2009", "Min, Chen and Chai 2009",
     R"(  author = {Min, Jianyuan and Chen, Yen-Lin and Chai, Jinxiang},
  title = {Interactive Generation of Human Animation with Deformable Motion Models},
  journal = {ACM Transactions on Graphics},
  volume = {29},
  number = {1},
  year = {2009})"},
    {"gleicher1998", "Gleicher 1998",
     R"(  author = {Gleicher, Michael},
  title = {Retargetting Motion to New Characters},
  booktitle = {Proceedings of SIGGRAPH 98},
  pages = {33--42},
  year = {1998})",
     "inproceedings"},
    {"neff2009", "Neff and Kim 2009",
     R"(  author = {Neff, Michael and Kim, Yejin},
  title = {Interactive Editing of Motion Style Using Drives and Correlations},
  booktitle = {Proceedings of the 2009 ACM SIGGRAPH/Eurographics Symposium on Computer Animation},
  pages = {103--112},
  year = {2009})",
     "inproceedings"},
    {.key = "emotionthesis2010",
     .label = "master's thesis of 2010",
     .missing = "a master's thesis of 2010, “Algorithmic modifications to the emotional content of "
                "motion capture data”, Aalto University, School of Science, Department of Media "
                "Technology, 75 pages; its author is missing (probably Klaus Förger)"},
    {.key = "forger2012",
     .label = "Förger and Takala 2012",
     .missing = "Förger and Takala, 2012, on incremental motion interpolation; title and place of "
                "publication are missing"},
    {"embree2014", "Wald et al. 2014",
     R"(  author = {Wald, Ingo and Woop, Sven and Benthin, Carsten and Johnson, Gregory S. and Ernst, Manfred},
  title = {Embree: A Kernel Framework for Efficient {CPU} Ray Tracing},
  journal = {ACM Transactions on Graphics},
  volume = {33},
  number = {4},
  articleno = {143},
  year = {2014},
  doi = {10.1145/2601097.2601199})"},
    {"ebur128", "European Broadcasting Union 2020",
     R"(  author = {{European Broadcasting Union}},
  title = {{EBU} {R}\,128: Loudness Normalisation and Permitted Maximum Level of Audio Signals},
  year = {2020},
  address = {Geneva})",
     "techreport"},
    {"li2020", "Li, Joo, Yeatman and Reinecke 2020",
     R"(  author = {Li, Qisheng and Joo, Sung Jun and Yeatman, Jason D. and Reinecke, Katharina},
  title = {Controlling for Participants' Viewing Distance in Large-Scale, Psychophysical Online
    Experiments Using a Virtual Chinrest},
  journal = {Scientific Reports},
  volume = {10},
  pages = {904},
  year = {2020},
  doi = {10.1038/s41598-019-57204-1})"},
    {"mariooryad2015", "Mariooryad and Busso 2015",
     R"(  author = {Mariooryad, Soroosh and Busso, Carlos},
  title = {Correcting Time-Continuous Emotional Labels by Modeling the Reaction Lag of Evaluators},
  journal = {IEEE Transactions on Affective Computing},
  volume = {6},
  number = {2},
  pages = {97--108},
  year = {2015},
  doi = {10.1109/TAFFC.2014.2334294})"},
    {.key = "adjectives",
     .label = "paper on adjectives",
     .missing =
         "a paper on motion interpolation with parameters based on adjectives, in an extended "
         "version with 41 adjective pairs; authors, exact title, year and place of publication "
         "are missing"},
};

std::string entry_of(const Reference& reference) {
  return fmt::format("@{}{{{},\n{}\n}}\n", reference.kind, reference.key, reference.bibtex);
}

std::string own_entry() {
  return fmt::format(
      "@misc{{mien,\n  title = {{mien: offline production of human-motion stimuli}},\n"
      "  version = {{{}}},\n  year = {{{}}},\n  note = {{Computer program}}\n}}\n",
      program_version(), release_date().substr(0, 4));
}

}  // namespace

std::span<const Reference> all_references() { return references; }

const Reference* find_reference(std::string_view key) {
  const auto* found = std::ranges::find(references, key, &Reference::key);
  return found == std::end(references) ? nullptr : found;
}

std::string bibtex_of(const std::vector<std::string>& keys) {
  std::string text;
  for (const Reference& reference : references) {
    if (std::ranges::find(keys, reference.key) == keys.end()) continue;
    text += entry_of(reference) + "\n";
  }
  return text + own_entry();
}

}  // namespace mien::pipeline
