# Shared by app/run and tests/run: says what it does, installs what is missing, fails with one line.

say() { printf '\033[1m==>\033[0m %s\n' "$*"; }
die() { printf 'error: %s\n' "$*" >&2; exit 1; }

# need LIST…: installs the packages of these lists (resources/packages/LIST.txt) that are missing.
need() {
    local list package missing=()
    for list in "$@"; do
        while read -r package; do
            [[ -z $package || $package == \#* ]] && continue
            [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
        done <"resources/packages/$list.txt"
    done
    ((${#missing[@]} == 0)) && return
    command -v apt-get >/dev/null || die "these packages are missing and there is no apt-get: ${missing[*]}"
    local as_root=()
    if ((EUID != 0)); then
        command -v sudo >/dev/null || die "root or sudo is needed to install: ${missing[*]}"
        as_root=(sudo)
    fi
    say "installing ${#missing[@]} missing packages: ${missing[*]}"
    local log
    log=$(mktemp)
    { "${as_root[@]}" apt-get update &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } \
        >"$log" 2>&1 || { tail -n 5 "$log" >&2; die "installing packages failed; the whole log is in $log"; }
    rm -f "$log"
}

# build PRESET TARGET…: configures once, builds what changed; quiet unless something fails. OPTIONS: extra -D… settings.
build() {
    local preset=$1 log
    shift
    log=$(mktemp)
    if [[ ! -f build/$preset/build.ninja ]]; then
        say "configuring $preset"
        cmake --preset "$preset" ${OPTIONS:-} >"$log" 2>&1 || { tail -n 30 "$log" >&2; die "configuring $preset failed"; }
    fi
    say "building $preset"
    cmake --build --preset "$preset" ${1:+--target "$@"} >"$log" 2>&1 ||
        { grep -E 'error|FAILED' "$log" | head -n 30 >&2; die "building $preset failed; the whole log is in $log"; }
    rm -f "$log"
}
