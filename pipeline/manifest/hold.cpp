#include "pipeline/manifest/hold.h"

#include "pipeline/reading/field_reader.h"
#include "pipeline/reading/field_writer.h"

namespace mien::pipeline {

void HoldForm::read(const Given& given, Hold& hold) {
  hold = Hold();
  hold.others = given.value == "others";
  pipeline::read(given, hold.names);
  pipeline::read(given, hold.values);
}

OrderedJson HoldForm::write(const Hold& hold, const Writing& how) {
  if (hold.others) return "others";
  return hold.names.empty() ? written(hold.values, how) : written(hold.names, how);
}

}  // namespace mien::pipeline
