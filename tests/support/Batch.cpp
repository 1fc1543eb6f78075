#include "tests/support/Batch.h"

#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace taa::test {

ProcessResult batch(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), binary("taa-batch").string());
  return runProcess(arguments);
}

namespace {

void expectMistake(int exitCode, const std::vector<std::string>& arguments,
                   const std::vector<std::string>& words) {
  const ProcessResult result = batch(arguments);
  EXPECT_EQ(result.exitCode, exitCode) << result.err;
  EXPECT_EQ(result.out, "");
  ASSERT_GE(result.err.size(), 2u);
  const std::size_t line =
      result.err.rfind('\n', result.err.size() - 2) + 1; // the last one; before it are notes
  EXPECT_TRUE(result.err.substr(line).starts_with("taa-batch: ")) << result.err;
  EXPECT_EQ(result.err.back(), '\n');
  for (const std::string& word : words) EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
}

} // namespace

void expectUsageError(const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
  expectMistake(2, arguments, words);
}

void expectFailure(const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
  expectMistake(1, arguments, words);
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

} // namespace taa::test
