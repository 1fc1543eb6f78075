# libFuzzer over everything that reads files of others: a program for each kind of file, from seeds that
# tests/fuzz/seeds writes. Sourced by tests/run, after app/setup.sh.

fuzzPackages=(clang libclang-rt-dev python3)

# What no input may do: wait longer than 5 s, take more than 1 GiB beyond what the sanitizers take themselves.
fuzzLimits=(-timeout=5 -rss_limit_mb=1536 -malloc_limit_mb=1024)

# Runs the program of target $2 for $3 seconds; what it found stays in build/fuzz/findings.
fuzzTarget() {
  local folder=$1 target=$2 seconds=$3
  mkdir -p "$folder/findings/$target"
  "$folder/bin/Fuzz$target" "${fuzzLimits[@]}" -max_total_time="$seconds" -max_len=8192 -reload=0 -print_final_stats=1 \
    -dict="$folder/$target.dict" -artifact_prefix="$folder/findings/$target/" "$folder/corpus/$target" \
    >"$folder/findings/$target.log" 2>&1 </dev/null || { tail -n 40 "$folder/findings/$target.log" >&2; return 1; }
  say "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/findings/$target.log") inputs in $seconds s, nothing found"
}

# Adds to the counts of tests/run, a check a target of $2 seconds each.
testFuzz() {
  local root=$1 seconds=$2 folder=$1/build/fuzz target
  installPackages "${fuzzPackages[@]}"
  (buildPreset fuzz) || { count failed; return; }
  "$root/tests/fuzz/seeds" "$folder" || { count failed; return; }
  for target in "$folder"/bin/Fuzz*; do
    target=${target##*/Fuzz}
    say "Changing files of kind $target for $seconds s"
    if fuzzTarget "$folder" "$target" "$seconds"; then count passed; else count failed; fi
  done
}
