// What something that fails says.
#pragma once

#include "core/base/Error.h"

#include <string>

namespace taa::test {

/// The message of the Error that `action` throws; empty where it throws none.
inline std::string errorOf(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

} // namespace taa::test
