#pragma once

#include <string>

#include <gtest/gtest.h>

#include "render/error.h"

namespace mien::render::test {

/// What the call's Error says; a failure of the test when it throws none.
template <typename Call>
std::string refusal_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

}  // namespace mien::render::test
