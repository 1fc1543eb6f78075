#include "core/sweep/PointClaim.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/json/Json.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <sstream>
#include <system_error>
#include <utility>

namespace taa {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxClaimBytes = 4096;

std::string lineOfSystem(const char* file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// Field 22 of /proc/PID/stat, counted after the name, which may hold anything; −1: there is no such process,
/// or it has ended and nobody has asked how.
long long startOf(long long process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(in, text);
  const std::size_t name = text.rfind(')');
  if (name == std::string::npos) return -1;
  std::istringstream fields(text.substr(name + 1));
  std::string state, skipped;
  constexpr int kFieldsBetween = 18; // from the state, the third, to the start, the 22nd
  fields >> state;
  for (int field = 0; field < kFieldsBetween; ++field) fields >> skipped;
  long long start = -1;
  return fields >> start && state != "Z" ? start : -1;
}

std::string ownerText(const ClaimOwner& owner) {
  return Json{{"host", owner.host}, {"process", owner.process}, {"started", owner.started}}.dump() + "\n";
}

std::optional<ClaimOwner> readOwner(const fs::path& file) {
  try {
    const Json json = Json::parse(readFile(file, kMaxClaimBytes));
    return ClaimOwner{json.at("host"), json.at("process"), json.at("started")};
  } catch (const std::exception&) { // not JSON, not that, or gone meanwhile
    return {};
  }
}

/// By the clock of the file system, which all hosts share: when it was touched, −1 where it is gone.
double touchedAt(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return -1.0;
  return static_cast<double>(status.st_mtim.tv_sec) + 1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

/// False: there is one. Throws Error.
bool makeExclusively(const fs::path& file, const std::string& text) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST) return false;
  if (descriptor < 0) throw Error(say<"cannot claim %1: %2">(file.string(), std::strerror(errno)));
  const bool isWritten = ::write(descriptor, text.data(), text.size()) == static_cast<::ssize_t>(text.size());
  const int reason = errno;
  ::close(descriptor);
  if (!isWritten) {
    std::error_code ignored;
    fs::remove(file, ignored);
    throw Error(say<"cannot claim %1: %2">(file.string(), std::strerror(reason)));
  }
  return true;
}

/// How long ago a claim gave its last sign of life; nothing: it is gone. A file that is made now tells the
/// time by the same clock.
std::optional<std::chrono::seconds> silenceOf(const fs::path& claim) {
  const ClaimOwner own = thisProcess();
  const fs::path clock = claim.parent_path() / ("." + std::to_string(std::hash<std::string>()(own.host)) +
                                                "." + std::to_string(own.process) + ".clock");
  std::ofstream(clock, std::ios::trunc) << "now\n";
  const double now = touchedAt(clock);
  std::error_code ignored;
  fs::remove(clock, ignored);
  const double then = touchedAt(claim);
  if (then < 0.0) return {};
  return std::chrono::seconds(static_cast<long long>(now - then));
}

} // namespace

ClaimOwner thisProcess() {
  std::array<char, 256> name{}, space{};
  ::gethostname(name.data(), name.size() - 1);
  const ::ssize_t length = ::readlink("/proc/self/ns/pid", space.data(), space.size() - 1);
  const std::string processes = length > 0 ? space.data() : "";
  return {std::string(name.data()) + " " + lineOfSystem("/proc/sys/kernel/random/boot_id") + " " + processes,
          ::getpid(), startOf(::getpid())};
}

bool isRunning(const ClaimOwner& owner) {
  const long long started = startOf(owner.process);
  return started >= 0 && started == owner.started;
}

bool isStale(const std::optional<ClaimOwner>& owner, const std::string& thisHost, std::chrono::seconds silent,
             std::chrono::seconds timeout) {
  if (owner && owner->host == thisHost) return !isRunning(*owner);
  return silent > timeout;
}

PointClaim::PointClaim(fs::path folder, std::string name, int number)
    : folder_(std::move(folder)), name_(std::move(name)), number_(number),
      touched_(std::chrono::steady_clock::now()) {}

PointClaim::PointClaim(PointClaim&& other) noexcept
    : folder_(std::move(other.folder_)), name_(std::move(other.name_)),
      number_(std::exchange(other.number_, -1)), touched_(other.touched_) {}

// Stale claims before it stay: without them one with a lower number could be made beside a later one.
PointClaim::~PointClaim() {
  std::error_code ignored;
  if (number_ >= 0) fs::remove(file(number_), ignored);
}

std::optional<PointClaim> PointClaim::take(const fs::path& folder, const std::string& name,
                                           std::chrono::seconds timeout) {
  const ClaimOwner own = thisProcess();
  PointClaim claim(folder, name, -1);
  int number = 0;
  std::error_code ignored;
  while (fs::exists(claim.file(number), ignored)) ++number;
  if (number > 0) {
    const fs::path last = claim.file(number - 1);
    const std::optional<ClaimOwner> owner = readOwner(last);
    const bool isOfThisHost = owner && owner->host == own.host; // no clock is needed
    const std::optional<std::chrono::seconds> silent =
        isOfThisHost ? std::chrono::seconds(0) : silenceOf(last);
    if (!silent || !isStale(owner, own.host, *silent, timeout)) return {};
  }
  if (!makeExclusively(claim.file(number), ownerText(own))) return {};
  claim.number_ = number;
  return claim;
}

void PointClaim::touch() {
  const auto now = std::chrono::steady_clock::now();
  if (now - touched_ < std::chrono::seconds(1)) return;
  touched_ = now;
  ::utimensat(AT_FDCWD, file(number_).c_str(), nullptr, 0);
}

void PointClaim::finish() {
  std::error_code ignored;
  for (int number = std::exchange(number_, -1); number >= 0; --number) fs::remove(file(number), ignored);
}

fs::path PointClaim::file(int number) const {
  return folder_ / (name_ + "-" + std::to_string(number));
}

} // namespace taa
