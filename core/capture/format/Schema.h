// The JSON schema of capture.json, for editors and validators: resources/capture/capture.schema.json.
#pragma once

#include <string>

namespace taa::capture {

/// Draft 2020-12, written from the tables. What depends on several values (contradictions, counts that rise)
/// is left to parseManifest.
std::string schemaText();

} // namespace taa::capture
