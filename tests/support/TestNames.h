// Names of the tests in the sources, for tables that say which test holds what.
#pragma once

#include <set>
#include <string>

namespace taa::test {

/// "Suite.Name" of every TEST, TEST_F and TEST_P below tests/.
std::set<std::string> testNames();

} // namespace taa::test
