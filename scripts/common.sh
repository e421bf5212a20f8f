# Shared by the scripts beside it; sourced, not run.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

die() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
    exit 1
}

# Seconds since the epoch, with milliseconds.
now() { date +%s.%3N; }

# elapsed START: seconds since START, one decimal.
elapsed() { awk -v a="$1" -v b="$(now)" 'BEGIN { printf "%.1f", b - a }'; }

# usage FILE: the comment block at the top of a script, as its help text.
usage() { awk 'NR > 1 { if (!/^#/) exit; sub(/^# ?/, ""); print }' "$1"; }

# The wasm-bindgen version that Cargo.lock holds: the command must match it exactly.
wasm_bindgen_version() {
    awk -F'"' '$0 == "name = \"wasm-bindgen\"" { hit = 1; next } hit && /^version/ { print $2; exit }' "$root/Cargo.lock"
}

# Kept outside the repository, so that a fresh clone need not build it again.
wasm_bindgen_dir() {
    printf '%s/welkin/tools/wasm-bindgen-%s' "${XDG_CACHE_HOME:-$HOME/.cache}" "$(wasm_bindgen_version)"
}

# Path of a wasm-bindgen command of the right version, or failure.
find_wasm_bindgen() {
    local want candidate
    want=$(wasm_bindgen_version)
    for candidate in "$(command -v wasm-bindgen || true)" "$(wasm_bindgen_dir)/bin/wasm-bindgen"; do
        if [[ -n $candidate && -x $candidate && $("$candidate" --version 2>/dev/null) == "wasm-bindgen $want" ]]; then
            printf '%s\n' "$candidate"
            return 0
        fi
    done
    return 1
}

# Path of a Chromium, or failure. $CHROMIUM wins.
find_chromium() {
    if [[ -n ${CHROMIUM:-} ]]; then
        [[ -x $CHROMIUM ]] || return 1
        printf '%s\n' "$CHROMIUM"
        return 0
    fi
    command -v chromium || command -v chromium-browser || command -v google-chrome
}

# wasm_is_stale DIR: true if DIR has no wasm module, or one that is older than what it is built from.
wasm_is_stale() {
    local module modules
    mapfile -t modules < <(find "$root/$1" -name '*_bg.wasm' 2> /dev/null)
    ((${#modules[@]})) || return 0
    for module in "${modules[@]}"; do
        [[ -z $(cd "$root" && find src shaders web/src web/Cargo.toml Cargo.toml Cargo.lock -newer "$module" -type f -print -quit) ]] || return 0
    done
    return 1
}
