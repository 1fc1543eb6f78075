#include "core/base/FreeMemory.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

namespace taa {

namespace {

std::string contents(const char* path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

std::optional<std::size_t> number(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return std::nullopt;
  std::size_t value = 0;
  const auto result = std::from_chars(text.data() + begin, text.data() + text.size(), value);
  return result.ec == std::errc() ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<std::size_t> availableIn(std::string_view meminfo) {
  constexpr std::string_view kName = "MemAvailable:";
  const std::size_t at = meminfo.find(kName);
  if (at == std::string_view::npos) return std::nullopt;
  const std::optional<std::size_t> kibibytes = number(meminfo.substr(at + kName.size()));
  return kibibytes ? std::optional(*kibibytes * 1024) : std::nullopt;
}

std::optional<std::size_t> freeMemory() {
  const std::optional<std::size_t> machine = availableIn(contents("/proc/meminfo"));
  // "max" where the group has no limit, and no files outside of groups.
  const std::optional<std::size_t> limit = number(contents("/sys/fs/cgroup/memory.max"));
  const std::optional<std::size_t> used = number(contents("/sys/fs/cgroup/memory.current"));
  if (!limit || !used) return machine;
  const std::size_t group = *limit > *used ? *limit - *used : 0;
  return machine ? std::min(*machine, group) : group;
}

} // namespace taa
