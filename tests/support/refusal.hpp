#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "fingerpad/error.hpp"

namespace fingerpad::test {

/// Why `make` is refused; "taken" where it is not.
inline std::string why_not(const std::function<void()>& make, ErrorKind kind = ErrorKind::refused) {
  try {
    make();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  return "taken";
}

}  // namespace fingerpad::test
