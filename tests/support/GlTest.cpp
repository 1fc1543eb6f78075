#include "tests/support/GlTest.h"

#include "core/base/Error.h"

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

namespace taa::test {

namespace {

// Kept to the end of the process: a context costs more than most tests.
std::unique_ptr<gl::Context> sharedContext;

void openSharedContext() {
  if (sharedContext) return;
  sharedContext = std::make_unique<gl::Context>();
  const gl::Driver& driver = sharedContext->driver();
  std::cout << "GL driver: " << driver.renderer << ", " << driver.version << std::endl;
}

} // namespace

gl::Context& GlTest::context() {
  return *sharedContext;
}

void GlTest::SetUp() {
  try {
    openSharedContext();
  } catch (const Error& error) {
    if (std::getenv("TAA_REQUIRE_GL")) FAIL() << error.what();
    GTEST_SKIP() << error.what();
  }
  sharedContext->makeCurrent(); // tests of whatever has a context of its own leave none behind
  sharedContext->takeMessages();
}

void GlTest::TearDown() {
  if (!sharedContext) return;
  for (const std::string& message : sharedContext->takeMessages())
    ADD_FAILURE() << "the driver says: " << message;
}

} // namespace taa::test
