// The taa-batch line that makes the picture of a session's view again.
#pragma once

#include "core/inspect/Comparison.h"
#include "core/io/SessionFile.h"
#include "core/measure/Metrics.h"
#include "core/picture/Visualizer.h"

#include <memory>
#include <string>

namespace taa {

struct CaptureFacts;

/// A word as a POSIX shell reads it back: quoted where it has to be.
std::string shellQuoted(const std::string& word);

/// A path of more poses than one is said by a file (cameraTrackJson()).
bool needsCameraFile(const SessionFile& session);

/// What a view shows.
struct CommandView {
  IntermediateId id = IntermediateId::resolved;
  ViewStyle style{}; ///< of what is shown: of the difference where that is
  Comparison comparison{};
  Showing showing = Showing::First;
  ViewStyle otherStyle{}; ///< of the other side
  double divider = 0.5;   ///< share of the picture's width
  int referenceSamples = kReferenceSamples;
  std::shared_ptr<const CaptureFacts> capture =
      nullptr; ///< of the shot, shared with who knows it; null: a scene
};

/// "taa-batch render … --format png --out .": the session's shot, frame and settings, and one intermediate in
/// this style, beside what it is compared with, all of the picture at 1:1. A flown path is read from
/// `cameraFile`, see needsCameraFile().
std::string renderCommand(const SessionFile& session, const CommandView& view,
                          const std::string& cameraFile = {});

} // namespace taa
