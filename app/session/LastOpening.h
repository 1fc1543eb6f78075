// What the session asked to be opened last, so that it can be asked for again, and what sources may ask for
// that were opened though they were refused.
#pragma once

#include "core/io/SessionFile.h"
#include "core/scene/SceneCost.h"

#include <map>
#include <optional>
#include <string>

namespace taa::app {

struct LastOpening {
  SessionFile file;
  bool isWhole = false; ///< all that the file says was asked for; else its source and choice
  bool plays = false;
  std::optional<SceneBudget> needed; ///< it was refused for asking for more than it may: this lets it in
  std::map<std::string, SceneBudget> letIn; ///< by source

  /// What a source may ask for; nothing: what all may.
  std::optional<SceneBudget> budgetOf(const std::string& source) const {
    const auto known = letIn.find(source);
    return known == letIn.end() ? std::nullopt : std::optional(known->second);
  }
};

} // namespace taa::app
