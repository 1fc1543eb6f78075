// Names of the tests in the sources, for tables that say which test holds what, and which techniques they
// show.
#pragma once

#include <set>
#include <string>

namespace taa::test {

/// "Suite.Name" of every TEST, TEST_F and TEST_P below tests/.
std::set<std::string> testNames();
/// Rows of the table of techniques that a test below tests/ shows the effect of: "// Techniques: 1.1, J3."
/// right above it.
std::set<std::string> techniquesWithTests();

} // namespace taa::test
