// The doctor in the manual: what it measures, when it says so, and what it leaves open.
#pragma once

#include <string>

namespace taa {

/// Markdown, a section with its own parts.
std::string doctorManual();

} // namespace taa
