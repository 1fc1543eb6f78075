// Who computes a point: a file that one process can make, so that no other one does the same work.
//
// Claims on a point are numbered: whoever makes the file of the next free number holds it, which the file
// system lets only one do (O_EXCL). One is free when there is no claim before it, or when the one before is
// stale: made on this host by a process that has ended, or on another one and without a sign of life for
// longer than a timeout.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace taa {

inline constexpr std::chrono::seconds kClaimTimeout{600};

/// A process, and where it runs.
struct ClaimOwner {
  std::string host; ///< name, boot and process namespace: numbers of processes mean something within one
  long long process = 0;
  long long started = 0; ///< ticks after boot, of the process: a number that is used again is another one

  bool operator==(const ClaimOwner&) const = default;
};

/// This process.
ClaimOwner thisProcess();
/// Whether it still runs; expects one of this host.
bool isRunning(const ClaimOwner& owner);

/// `owner`: nothing where the file does not say, because its maker was ended while it wrote; `silent`: time
/// since the claim's last sign of life.
bool isStale(const std::optional<ClaimOwner>& owner, const std::string& thisHost, std::chrono::seconds silent,
             std::chrono::seconds timeout);

/// A claim of this process. Gives the point up when it is destroyed.
class PointClaim {
 public:
  /// On point `name`, in `folder`, which is there; nothing: somebody else works on it. Throws Error where no
  /// file can be made.
  static std::optional<PointClaim> take(const std::filesystem::path& folder, const std::string& name,
                                        std::chrono::seconds timeout);
  PointClaim(PointClaim&& other) noexcept;
  PointClaim& operator=(PointClaim&&) = delete;
  ~PointClaim();

  /// A sign of life; costs nothing where there was one within the last second.
  void touch();
  /// The point is computed: takes away the stale claims before this one, too.
  void finish();

 private:
  PointClaim(std::filesystem::path folder, std::string name, int number);
  std::filesystem::path file(int number) const;

  std::filesystem::path folder_;
  std::string name_;
  int number_ = -1; ///< −1: given away
  std::chrono::steady_clock::time_point touched_;
};

} // namespace taa
