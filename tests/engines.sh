# Frames of real engines: renders eight with each example of resources/capture/examples, and imports them.
# Sourced by tests/run, after app/setup.sh.

# What npm fetched is kept between runs.
engineCache=${XDG_CACHE_HOME:-$HOME/.cache}/taa-inspector/engines

# Copies the examples of the web into the cache, where their libraries lie, so that the checkout stays as it is.
prepareWeb() {
  local root=$1
  mkdir -p "$engineCache"
  cp "$root"/resources/capture/examples/web/* "$engineCache/"
  (cd "$engineCache" && npm install --no-audit --no-fund --loglevel=error)
}

# Renders frames of engine $2 into folder $3.
takeFrames() {
  local root=$1 engine=$2 folder=$3
  case $engine in
    blender)
      blender -b -noaudio -P "$root/resources/capture/examples/blender/taa_capture.py" -- "$folder" --frames 1..8 \
        --reference 16 >"$folder.log" 2>&1 ;;
    *) (cd "$engineCache" && node capture.mjs "$engine" "$folder" --frames 8 >"$folder.log" 2>&1) ;;
  esac || { tail -n 20 "$folder.log" >&2; return 1; }
}

# Whether frames of engine $2 can be taken, are what they say they are, and go through the resolve.
testEngine() {
  local root=$1 engine=$2 folder=$3 batch=$1/build/dev/bin/taa-batch
  say "Taking frames of $engine"
  takeFrames "$root" "$engine" "$folder" &&
    "$batch" import "$folder" --check &&
    "$batch" render "$folder" --frames 0..7 --emit resolved,motion,rejectReason --out "$folder/out" >"$folder.render.log"
}

# Adds to the counts of tests/run, a check an engine.
testEngines() {
  local root=$1 folder engine
  local packages=(chromium blender)
  # Debian's npm goes with no other node than Debian's.
  command -v npm >/dev/null || packages+=(nodejs npm)
  installPackages "${packages[@]}"
  folder=$(mktemp -d "${TMPDIR:-/tmp}/taa-engines.XXXXXX")
  prepareWeb "$root" || { count failed; return; }
  for engine in three babylon blender; do
    if testEngine "$root" "$engine" "$folder/$engine"; then count passed; else count failed; fi
  done
  rm -rf "$folder"
}
