// Words and numbers of a lesson's header.
#pragma once

#include <glm/vec2.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

std::string_view withoutBlanks(std::string_view text);
/// What spaces and tabs part.
std::vector<std::string_view> wordsOf(std::string_view text);

// All throw Error that says what was expected.
double numberFrom(std::string_view text);
int wholeNumberFrom(std::string_view text, int least, int most);
/// "120,60"
glm::ivec2 pixelFrom(std::string_view text);
/// `what`: "key", "page". Names the nearest one where there is none.
void requireName(std::string_view name, std::span<const std::string_view> known, const std::string& what);

} // namespace taa
