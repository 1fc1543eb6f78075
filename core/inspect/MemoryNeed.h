// How much graphics memory a picture takes: known from settings and size alone, before anything is allocated.
#pragma once

#include "core/gl/Context.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace taa {

struct Scene;

/// Bytes of textures, besides those of the scene, the views and the kept histories.
struct MemoryNeed {
  std::size_t inputs = 0;        ///< of the frame on show and of the one that is made, and what drawing keeps
  std::size_t histories = 0;     ///< that a frame is resolved from and into, and those used again
  std::size_t intermediates = 0; ///< of what is watched, for both frames
  std::size_t reference = 0;     ///< where rows of it are watched: drawing it, those rows and their frames
  std::size_t total() const { return inputs + histories + intermediates + reference; }
};

/// `scene`: that is drawn; null: none, or one with neither fog nor shadows.
MemoryNeed memoryNeed(const std::vector<Settings>& lanes, const glm::ivec2& picturePx,
                      const std::vector<IntermediateId>& watched, const Scene* scene = nullptr);

/// Drawing the reference alone, bytes.
std::size_t referenceBytes(const Settings& settings, const glm::ivec2& picturePx,
                           const Scene* scene = nullptr);

/// "512 MiB", "2.4 GiB".
std::string bytesText(std::size_t bytes);

/// Why a picture cannot be had, as a sentence for the user; empty where it can. `available`: bytes there are.
std::string memoryRefusal(const MemoryNeed& need, const glm::ivec2& picturePx, std::size_t available);
/// Why the reference of one cannot be drawn, in the same way.
std::string referenceRefusal(std::size_t bytes, const glm::ivec2& picturePx, std::size_t available);

/// Throws Error where the driver or its memory is too small for lanes of a picture. What is held now is not
/// counted on: it goes only when the new is there.
void requirePicture(const gl::Driver& driver, const std::vector<Settings>& lanes, const glm::ivec2& picturePx,
                    const std::vector<IntermediateId>& watched, const Scene* scene);
/// Throws Error where there are not the `bytes` that drawing a reference takes.
void requireReference(const gl::Driver& driver, std::size_t bytes, const glm::ivec2& picturePx);

} // namespace taa
