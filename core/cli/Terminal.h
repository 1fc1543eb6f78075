// What taa-batch says on standard error: every sentence goes through here, one line each.
#pragma once

#include <string>
#include <string_view>

namespace taa::cli {

/// "taa-batch: …": why it ends. Of what a compiler says the lines stay lines.
void tellFailure(std::string_view sentence);
/// "note: …", "warning: …", "memory: …": goes on.
void tell(std::string_view kind, std::string_view sentence);

} // namespace taa::cli
