// Finished pictures (sRGB, 8 bits) as PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace taa {

/// width · height RGBA pixels as the bytes of a file, as writePng() writes them. Throws Error.
std::string packedPng(int width, int height, std::span<const std::uint8_t> rgba);

/// Writes width · height RGBA pixels, row 0 the top, alpha not multiplied in; all of the file or nothing.
/// Throws Error.
void writePng(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgba);

} // namespace taa
