// Pictures as PNG: for files, and in the text of a page.
#pragma once

#include "core/base/Image.h"

#include <string>
#include <string_view>

namespace taa {

/// The bytes of a file. `picture`: as a screen is sent it, 0 to 1, three channels at least. Throws Error.
std::string pngOfShown(const Image& picture);

/// RFC 4648, with its padding.
std::string base64Of(std::string_view bytes);

} // namespace taa
