// Which planes the names of files, folders, parts and channels speak of.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/capture/planes/PictureParts.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

/// What words like "ViewLayer.Vector", "motion_vectors" or "SceneDepth" name; nothing where no word is known.
std::optional<PlaneKind> kindOfName(std::string_view name);

/// A channel within its layer: "velocity.X" is x of velocity.
struct LayerChannel {
  std::string name;      ///< whole, as the file has it
  std::string component; ///< "x", "r": one letter in lower case; empty: it is called by none
  StoredType type = StoredType::Float;
};

/// Channels of a file that belong together by their names.
struct PictureLayer {
  std::string part, name; ///< part: of a multi-part EXR; name: empty where channels have none but their own
  glm::ivec2 sizePx{0};
  std::vector<LayerChannel> channels; ///< as they come
};

/// Depth that lies beside color in a layer without a name is a layer of its own.
std::vector<PictureLayer> layersOf(const std::vector<PicturePart>& parts);

/// The channels of a layer that a plane is read from, by their names in its order; empty: too few.
std::vector<std::string> channelsFor(const PictureLayer& layer, PlaneKind kind);

/// A plane that a file holds.
struct NamedPlane {
  PlaneKind kind = PlaneKind::Color;
  std::string part;
  std::vector<std::string> channels;
  StoredType type = StoredType::Float;
  glm::ivec2 sizePx{0};
  bool isNamed = false; ///< false: color, as nothing says otherwise
};

struct NamedPlanes {
  std::vector<NamedPlane> planes; ///< each kind once
  std::vector<std::string>
      ignored; ///< layers whose names say nothing that is known, or a kind for a second time
};

/// `file`: path below the folder, whose words name channels that are only called R, G, B.
NamedPlanes namedPlanes(const std::vector<PicturePart>& parts, const std::string& file);

} // namespace taa::capture
