// A folder of three small frames that an engine could have written: what the import page is tried on.
#pragma once

#include "core/capture/format/Manifest.h"

#include <filesystem>

namespace taa::app::test::small_frames {

inline constexpr int kWidth = 16, kHeight = 8, kFrames = 3;

/// What they are: color, motion and depth, numbered from 10.
capture::Manifest manifestOfFrames();
/// Their planes, without capture.json. The picture has no repetition within its width and moves one pixel to
/// the right a frame, as motion says.
void writeFrames(const std::filesystem::path& folder);

} // namespace taa::app::test::small_frames
