#include "pipeline/manifest/person_figure.h"

#include <variant>

namespace mien::pipeline {

scenes::Figure figure_of(const Person& person, const Look& look) {
  return scenes::with_face(person.figure ? *person.figure : look.figure,
                           person.face ? *person.face : look.face);
}

bool can_be_turned(const scenes::Figure& figure) {
  return std::holds_alternative<scenes::StickOptions>(figure) ||
         std::holds_alternative<scenes::MannequinOptions>(figure) ||
         std::holds_alternative<scenes::CharacterOptions>(figure);
}

}  // namespace mien::pipeline
