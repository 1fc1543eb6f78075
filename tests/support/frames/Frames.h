// Frames of a scene resolved one after another, and what the CPU twin says of them.
#pragma once

#include "core/probe/Verification.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/taa/TaaPass.h"
#include "core/taa/twin/Twin.h"

#include <array>
#include <string>
#include <vector>

namespace taa::test {

/// What the twin is given for a frame, downloaded.
twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous);

/// Compares pictures (in the table's order) with the twin's, every pixel: bit for bit when `exact`, else with
/// what GLSL allows a driver. Says how the first row that differs does, and names the others; empty when none
/// does.
std::string differenceFromTwin(twin::Inputs inputs, const Settings& settings,
                               const std::vector<Image>& pictures, bool exact);

/// The same pictures against what GLSL allows a driver.
Verification verified(twin::Inputs inputs, const Settings& settings, const std::vector<Image>& pictures);
/// A line for each row of which something is outside; empty: nothing is.
std::string outsideText(const Verification& verification);

/// Resolves frames one after another, each on the history of the one before.
class Accumulator {
 public:
  /// Fills `exposedRows` when given.
  void resolve(TaaPass& pass, const FrameInputs& inputs, const Settings& settings,
               ExposedRows* exposedRows = nullptr);

  const History& history() const { return histories_[current_]; }
  /// What the last frame was resolved on; null: nothing.
  const History* previous() const { return hadHistory_ ? &histories_[1 - current_] : nullptr; }

 private:
  std::array<History, 2> histories_;
  std::size_t current_ = 0;
  bool hadHistory_ = false;
};

/// Draws a scene's frames one after another and resolves them.
class Player {
 public:
  Player(const std::string& source, const std::string& camera, int width, int height,
         const Settings& settings);

  /// Draws the next frame.
  void draw();
  /// Draws the next frame and resolves it, filling `exposedRows` when given.
  void step(TaaPass& pass, ExposedRows* exposedRows = nullptr);

  const FrameInputs& inputs() const { return inputs_; }
  const History& history() const { return accumulator_.history(); }
  const History* previous() const { return accumulator_.previous(); }

 private:
  Settings settings_;
  FrameRequest request_;
  SceneRenderer renderer_;
  FrameInputs inputs_;
  Accumulator accumulator_;
  int frame_ = -1;
};

} // namespace taa::test
