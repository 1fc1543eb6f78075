// The reference page of the help: every stage, parameter and intermediate, told from the tables.
#pragma once

#include <string>

namespace taa {

/// HTML of the subset that Qt's rich text shows, in the order of the data. Nothing in it is written by hand
/// but the words between the tables.
std::string referencePageHtml();

} // namespace taa
