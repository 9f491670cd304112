# Sourced by the commands in this folder. A step is one command with its output in build/logs: one line on the
# terminal when it succeeds; when it fails, its last lines and the place of the log, and the end of the script.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs=$root/build/logs

# step NAME COMMAND...
step() {
    local name=$1 log=$logs/${1// /-}.log start=$SECONDS
    shift
    mkdir -p "$logs"
    if ! "$@" >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        echo "$(basename "$0"): '$name' failed; all it said is in $log" >&2
        exit 1
    fi
    echo "$name: $((SECONDS - start)) s"
}

# build PRESET [TARGET...]: configures and builds with every core.
build() {
    local preset=$1 targets=()
    shift
    if (($# > 0)); then targets=(--target "$@"); fi
    step "configure $preset" cmake -S "$root" --preset "$preset"
    step "build $preset" cmake --build "$root/build/$preset" --parallel "$(nproc)" "${targets[@]}"
}
