# The README's commands on a bare Debian: a root folder that debootstrap makes, a clone in it, app/run, tests/run.
# Sourced by tests/run, after app/setup.sh.

# What is kept between runs, so that the next one takes minutes less: packages and compiled objects, nothing that is tested.
bareCache=${XDG_CACHE_HOME:-$HOME/.cache}/taa-inspector/bare

# Runs "$@" in root folder $1, in the clone, with an environment that says nothing of this machine's.
inBare() {
  local root=$1
  shift
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 CCACHE_DIR=/ccache CI=true \
    chroot "$root" sh -c 'cd /root/taa-inspector && exec "$@"' sh "$@" </dev/null
}

unmountBare() {
  local root=$1 folder
  for folder in root/shared ccache var/cache/apt/archives dev/pts dev sys proc; do
    ! mountpoint -q "$root/$folder" || umount "$root/$folder" 2>/dev/null || umount -l "$root/$folder"
  done
}

# Makes root folder $2 a minimal Debian $1 with git and a clone of the tree that $3 holds as it is committed.
makeBare() {
  local suite=$1 root=$2 source=$3 kept=$bareCache/$1
  mkdir -p "$kept/archives/partial" "$kept/ccache" "$root"
  debootstrap --variant=minbase --cache-dir="$kept/archives" "$suite" "$root" >"$root.log" 2>&1 ||
    { tail -n 5 "$root.log" >&2; return 1; }
  mkdir -p "$root/ccache"
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys" && mount --make-rslave "$root/sys"
  mount --bind /dev "$root/dev"
  mount --bind "$kept/ccache" "$root/ccache"
  mount --bind "$kept/archives" "$root/var/cache/apt/archives"
  # Packages stay in the archive for the next run; names resolve as they do here.
  echo 'APT::Keep-Downloaded-Packages "true"; Binary::apt::APT::Keep-Downloaded-Packages "true";' >"$root/etc/apt/apt.conf.d/99keep"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  chroot "$root" env -u TMPDIR DEBIAN_FRONTEND=noninteractive sh -c \
    'apt-get update -q && apt-get install -y -q --no-install-recommends git ca-certificates' </dev/null >>"$root.log" 2>&1 ||
    { tail -n 5 "$root.log" >&2; return 1; }
  git clone -q --no-hardlinks "file://$source" "$root/root/taa-inspector" || return 1
  if [ -d "$source/../shared" ]; then
    mkdir "$root/root/shared"
    mount --bind -o ro "$(realpath "$source/../shared")" "$root/root/shared"
  fi
}

# Whether both commands of the README work on a bare Debian $1, in a clone of $2; the rest are options of tests/run.
testBare() {
  local suite=$1 source=$2 root
  shift 2
  [ "$(id -u)" -eq 0 ] || fail "--bare needs root, for debootstrap and chroot"
  installPackages debootstrap
  root=$(mktemp -d "${TMPDIR:-/tmp}/taa-bare-$suite.XXXXXX")
  # A stopped run leaves no mounts behind: rm -rf through one would delete what it shows.
  trap 'unmountBare "$root"' EXIT
  say "Making a bare Debian $suite in $root"
  makeBare "$suite" "$root" "$source" || fail "Debian $suite could not be made; see $root.log"
  say "app/run on Debian $suite"
  inBare "$root" ./app/run || fail "app/run fails on Debian $suite; its root folder stays in $root"
  [ -s "$root/root/taa-inspector/build/first-look.png" ] || fail "app/run on Debian $suite wrote no picture; see $root"
  say "tests/run on Debian $suite"
  inBare "$root" ./tests/run "$@" || fail "tests/run fails on Debian $suite; its root folder stays in $root"
  unmountBare "$root"
  trap - EXIT
  rm -rf --one-file-system "$root" "$root.log"
}
