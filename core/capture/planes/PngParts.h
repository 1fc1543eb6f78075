// The parts of a PNG, checked before a library reads them: that would say what is wrong on standard error.
#pragma once

#include "core/base/Files.h"

#include <string>

namespace taa::capture {

/// Throws Error, naming `name`, the part and its place, where a part ends behind the file, does not fit its
/// checksum, or the last one is missing. Expects a file that begins as a PNG does.
void checkPngParts(const UntrustedFile& file, const std::string& name);

} // namespace taa::capture
