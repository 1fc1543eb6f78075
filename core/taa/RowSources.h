// Which rows of a whole picture no run of the resolve has to write: a texture holds them anyway, they are
// constant with these settings, or another row is always equal.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"
#include "core/taa/History.h"
#include "core/taa/Intermediates.h"

#include <array>
#include <optional>

namespace taa {

/// A texture that holds a row bit for bit, from a channel on: one of the frame's inputs, or of the history
/// that the frame leaves.
struct HeldRow {
  gl::Texture FrameInputs::*input = nullptr;
  gl::Texture History::*history = nullptr; ///< where `input` is null
  int firstChannel = 0;
  bool operator==(const HeldRow&) const = default;
};

/// Nothing: the row is written.
struct RowSource {
  std::optional<HeldRow> held;
  std::optional<float> constant;      ///< of all channels
  bool isNumber = false;              ///< whether that is one of the settings' numbers, not a choice's
  std::optional<IntermediateId> same; ///< a row whose first channels are always equal; it is written
  bool operator==(const RowSource&) const = default;
};

/// Of all rows; at first all are written.
struct RowSources {
  std::array<RowSource, kResolveRowCount> rows{};
  std::size_t historyTargets = kHistoryTargets; ///< see historyTargets()

  const RowSource& of(IntermediateId id) const { return rows[static_cast<std::size_t>(id)]; }
};

/// Of a picture whose inputs are drawn as `settings` ask.
RowSources rowSources(const Settings& settings);

} // namespace taa
