// What the doctor examines: a scene as it is drawn, or a capture as its engine wrote it.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/format/Conventions.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/EngineOutput.h"
#include "core/scene/ShotChoice.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

/// Of a capture only the source counts, and what settings do not leave to it.
struct SourceRequest {
  std::string source;          ///< "builtin:NAME", a glTF file, a capture
  std::string camera;          ///< empty: the scene's own
  glm::ivec2 sizePx{640, 360}; ///< of the picture
  /// Of a scene all of them; of a capture its own output counts, unless a fault of the resolve is set.
  Settings settings;
  ShotChoice choice{}; ///< of a scene: its animation and length
};

struct DoctorSource {
  std::shared_ptr<FrameSource> frames;  // also owned by who reads them
  std::shared_ptr<EngineOutput> output; // also owned by who reads them; null: there is none
  std::shared_ptr<const Scene> scene;   ///< null: a capture
  FrameRequest request;
  KnownPlanes known;
  int frameCount = 0;
  std::map<std::uint32_t, std::string> objectNames;
  /// The engine's own; none: this program's.
  std::optional<capture::Conventions> conventions;
  FrameNames frameNames = {};             ///< of a capture: by the engine's numbers
  std::map<int, double> preExposure = {}; ///< see CaptureInfo
  std::vector<Finding> contradicted = {}; ///< of a capture: see correctContradicted()
};

/// A capture keeps the conventions that are stated or guessed, but for motion of the sky: that is examined as
/// it was stored. Needs the current context. Throws Error, Cancelled.
DoctorSource openForDoctor(const SourceRequest& request, const Progress& progress = {});

/// Frames are those that settings make from now on: their jitter, inputs and faults.
void drawWith(const Settings& settings, DoctorSource& source);

/// Frames of the source, which lives as long as the reader.
FrameReader readerOf(const DoctorSource& source);

} // namespace taa::doctor
