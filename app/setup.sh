# What app/run and tests/run share: the packages the project needs, and installing those that are missing.
# Sourced by bash. The names hold for Debian 13 and 12; tests/run --bare tries both.

# To build the programs and run them on a screen or without one.
buildPackages=(
  cmake ninja-build g++ pkg-config ccache
  qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-qpa-plugins qt6-wayland
  libgl-dev libegl-dev libepoxy-dev libgl1-mesa-dri libegl-mesa0
  libglm-dev libtinygltf-dev libopenimageio-dev nlohmann-json3-dev libcli11-dev libmd4c-dev zlib1g-dev
  fonts-dejavu-core
)
# To test them as well.
testPackages=(libgtest-dev libbenchmark-dev xvfb xauth)
# Where the system has it (Debian 12): another version would format otherwise.
formatPackage=clang-format-14

say() { printf '\033[1m==>\033[0m %s\n' "$*" >&2; }

fail() {
  printf '%s: %s\n' "$(basename "$(dirname "$0")")/$(basename "$0")" "$*" >&2
  exit 1
}

# Prints those of the given packages that are not installed.
missingPackages() {
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p')
  printf '%s\n' "$@" | grep -vxF "${installed:-none}" || true
}

# Installs those of the given packages that are missing; quick when none is.
installPackages() {
  command -v dpkg-query >/dev/null || fail "this system has no apt. Install the counterparts of these packages and call again with --no-install: $*"
  local missing asRoot=()
  mapfile -t missing < <(missingPackages "$@")
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "these packages are missing and there is no sudo. As root: apt-get install ${missing[*]}"
    asRoot=(sudo)
  fi
  say "Installing ${missing[*]}"
  local install=("${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}")
  # Package lists that are missing or old make the first try fail.
  "${install[@]}" </dev/null >/dev/null 2>&1 && return
  say "Updating the package lists"
  "${asRoot[@]}" apt-get update -q </dev/null >&2 || fail "the package lists could not be updated (no network?)"
  "${install[@]}" </dev/null >&2 || fail "apt-get could not install ${missing[*]}"
}

# Whether the package lists name package $1.
isKnownPackage() {
  apt-cache show "$1" >/dev/null 2>&1
}

# Configures the preset of this name if that was not done yet, and builds it; run in the repository root.
buildPreset() {
  if [ ! -f "build/$1/build.ninja" ]; then
    say "Configuring build/$1"
    cmake --preset "$1" >&2 || fail "build/$1 could not be configured; without --no-install what is missing would be installed"
  fi
  say "Building build/$1 (minutes the first time, a moment when nothing changed)"
  cmake --build "build/$1" >&2 || fail "build/$1 does not build; the errors are above"
}
