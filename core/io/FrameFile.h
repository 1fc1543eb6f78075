// One frame as a multi-part EXR: a part for each intermediate, 32-bit floats, row 0 the top.
#pragma once

#include "core/base/Image.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// How a lane came to its frame; written into the header of each of its parts.
struct FrameLane {
  std::string name; ///< "A", put before its parts' names; empty when it is the only one
  Settings settings;
  FrameInfo info;
  shared::FrameBlock block{};
  int referenceSamples = 0; ///< of the reference that rows are compared with; 0: there was none
};

/// What the values of a part are less of: the part is a difference.
struct FrameDifference {
  std::string with; ///< "motion:-1", as --compare has it
  IntermediateId row = IntermediateId::resolved;
  int lane = 0;               ///< index into FrameFile::lanes
  std::optional<int> frame{}; ///< nothing: there is none before the first
};

struct FramePart {
  int lane = 0; ///< index into FrameFile::lanes
  IntermediateId id = IntermediateId::resolved;
  Image image = {}; ///< the row's channels; empty where the values are asked for one part at a time
  std::optional<FrameDifference> difference{}; ///< NaN where there is nothing to compare with
};

struct FrameFile {
  std::string source, camera, driver;
  std::vector<FrameLane> lanes;
  std::vector<FramePart> parts;
};

/// Name of a part: the intermediate's id, after the lane's name and a dot where there is one ("A.resolved").
std::string partName(const FrameLane& lane, IntermediateId id);
/// "A.resolved.difference" where it is one.
std::string partName(const FrameLane& lane, const FramePart& part);

/// Writes all parts, or nothing. Channels are named by the table; attributes start with "taa:" (source,
/// camera, driver, lane, settings as JSON, frame, time, jitterPx, matrices, label, unit, description;
/// referenceSamples in parts of the reference; comparedWith, otherRow, otherFrame and otherSettings in
/// differences).
/// Expects images of one size. Throws Error.
void writeFrameFile(const std::filesystem::path& path, const FrameFile& frame);

/// The same with values that are asked for one part after the other, in their order, and let go when they are
/// written: not all of a large frame has to be in memory. Expects images of the size given.
void writeFrameFile(const std::filesystem::path& path, const FrameFile& frame, const glm::ivec2& sizePx,
                    const std::function<Image(const FramePart&)>& values);

/// Names of the parts of an EXR, in the order of the file. Throws Error.
std::vector<std::string> partNames(const std::filesystem::path& path);

/// The channels named `channels` of part `part`, whatever order the file has them in. Throws Error naming
/// what there is.
Image readPart(const std::filesystem::path& path, const std::string& part,
               const std::vector<std::string>& channels);

/// Attribute `name` of a part as text; empty when it has none. Throws Error.
std::string readPartAttribute(const std::filesystem::path& path, const std::string& part,
                              const std::string& name);

} // namespace taa
