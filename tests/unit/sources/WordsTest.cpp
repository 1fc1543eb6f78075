// What a file brought into a sentence reaches nobody but through core/base/ShownText: errors go through it as
// they are made, a library's reason by shownReason(), and the terminal has one way out for each program.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// Where `isWrong` holds of a source below core and app.
std::vector<std::string> sourcesWhere(const std::function<bool(const std::string&)>& isWrong) {
  std::vector<std::string> found;
  for (const char* root : {"core", "app"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root))
      if (entry.path().extension() == ".cpp" && isWrong(taa::readFile(entry.path())))
        found.push_back(entry.path().string());
  return found;
}

/// A reason that somebody else wrote, told as it is: caught as any exception, or as one of the library of
/// JSON.
bool tellsRawReason(const std::string& source) {
  static const std::regex kCatch(R"(catch \(\s*const (?:std|nlohmann::json|json|Json)::exception& (\w+)\))");
  for (std::sregex_iterator at(source.begin(), source.end(), kCatch), end; at != end; ++at) {
    const std::string after = at->suffix();
    const std::string handler = after.substr(0, after.find("\n}"));
    const std::size_t next = handler.find("catch (");
    if (handler.substr(0, next).find((*at)[1].str() + ".what()") != std::string::npos) return true;
  }
  return false;
}

} // namespace

TEST(Words, FindsAReasonThatIsToldAsItIs) {
  EXPECT_TRUE(tellsRawReason("  } catch (const std::exception& error) {\n    say(error.what());\n  }\n"));
  EXPECT_TRUE(tellsRawReason("  } catch (const Json::exception& wrong) {\n    say(wrong.what());\n  }\n"));
  EXPECT_FALSE(
      tellsRawReason("  } catch (const std::exception& error) {\n    say(shownReason(error));\n  }\n"));
  EXPECT_FALSE(tellsRawReason("  } catch (const Error& error) {\n    say(error.what());\n  }\n"));
}

TEST(Words, NobodyTellsAReasonAsALibraryWroteIt) {
  EXPECT_EQ(sourcesWhere(tellsRawReason), std::vector<std::string>{});
}

TEST(Words, OfTaaBatchGoToTheTerminalOneWay) {
  const auto found =
      sourcesWhere([](const std::string& source) { return source.find("std::cerr") != std::string::npos; });
  // main.cpp has the line of progress, which is the program's own.
  EXPECT_EQ(std::set<std::string>(found.begin(), found.end()),
            (std::set<std::string>{"core/cli/Terminal.cpp", "core/cli/main.cpp"}));
}
