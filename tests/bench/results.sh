#!/bin/sh
# Makes the files of tests/bench/results: each is the unedited output of one command, below a head that names the command, the
# commit and the machine. The machine should do nothing else meanwhile; all of them take about an hour on two cores.
#   sh tests/bench/results.sh [--missing] [NAME...]   all, or those by name or pattern; --missing: not those of this commit
#   sh tests/bench/results.sh --list                  name, "gl" where the driver matters, and command of each
set -e
cd "$(dirname "$0")/../.."
results=tests/bench/results
bench=build/release/tests/benchmarks
# An X server that does not start anew when its last client has gone: the next program would wait for it.
display='xvfb-run -a -s "-screen 0 1600x1000x24 -noreset"'

entries() {
    cat <<END
sdf_evaluations cpu $bench sdf_evaluations
interlacing cpu $bench interlacing
large_print cpu $bench large_print
hall_costs gl $bench hall_costs
window_start gl $display $bench window_start
your_shader gl $bench your_shader
portable gl $display $bench portable
window_latency gl $display $bench window_latency
web_hall gl sh tests/bench/web_hall/run.sh
isf_renderers gl sh tests/exhibits/your_shader/compare_renderers.sh "\$ISF_FILES" 2
stability_suite gl env VITRINE_SCAN_PRESETS=100 ctest --test-dir build/release -L stability -j 2
END
    sed "s,^\([^ ]*\) \(.*\),study_\1 gl build/release/vitrine study \2 --out build/studies/\1," tests/bench/studies.txt
}

# The results are what a run changes: they make no commit another one.
changes() { git status --porcelain -- . ':!tests/bench/results'; }
field() { printf '%s\n' "$machine" | sed -n "s/^$1	//p"; }
# "llvmpipe (LLVM 15.0.6, 256 bits), ..." is llvmpipe; "NVIDIA H200/PCIe/SSE2, ..." is nvidia-h200.
slug() { printf '%s\n' "$1" | sed 's/[(,\/].*//; s/[^A-Za-z0-9]\{1,\}/-/g; s/-$//' | tr '[:upper:]' '[:lower:]'; }

measure() {
    name=$1 kind=$2 command=$3
    machine=$($bench machine) || return 1
    file=$name
    [ "$kind" = cpu ] || file=$name-$(slug "$(field renderer)")
    if [ -n "$missing" ] && [ -z "$(changes)" ] && grep -qs "^| commit | $commit |$" "$results/$file.md"; then return 0; fi
    echo "$name: $command" >&2
    fence=""
    case $name in study_* | stability_suite) fence='```' ;; esac
    started=$(date +%s)
    eval "$command" >"$part/out" 2>"$part/err" </dev/null || { cat "$part/out" "$part/err" >&2; echo "$name: the command failed; its file stays as it was." >&2; return 1; }
    {
        printf '# %s\n\n| made with | |\n|---|---|\n| command | `%s` |\n| commit | %s |\n| date | %s |\n' "$name" "$command" \
            "$commit${dirty:+, $dirty}" "$(date -u '+%Y-%m-%d %H:%M UTC')"
        printf '| renderer | %s |\n| processor | %s |\n| load before | %s |\n| memcpy | %s GB/s |\n| took | %s s |\n\n---\n' \
            "$([ "$kind" = cpu ] && echo none || field renderer)" "$(field processor)" "$(field load)" "$(field memcpy)" $(($(date +%s) - started))
        [ -z "$fence" ] || echo "$fence"
        cat "$part/out"
        [ -z "$fence" ] || echo "$fence"
    } >"$part/file"
    mv "$part/file" "$results/$file.md"
}

# In a function, so that all of this is read before it runs: the script may change while it does.
main() {
    part=$(mktemp -d)
    trap 'rm -rf "$part"' EXIT
    missing="" left=""
    case ${1:-} in
    --list) entries; return ;;
    --missing) missing=yes; shift ;;
    esac
    commit=$(git rev-parse HEAD)
    [ -z "$(changes)" ] && dirty="" || dirty="with uncommitted changes"
    entries | while read -r name kind command; do
        [ $# -gt 0 ] || printf '%s %s %s\n' "$name" "$kind" "$command"
        for pattern in "$@"; do
            # shellcheck disable=SC2254
            case $name in $pattern) printf '%s %s %s\n' "$name" "$kind" "$command"; break ;; esac
        done
    done >"$part/chosen"
    [ -s "$part/chosen" ] || { echo "results.sh: there is no $*; --list tells the names." >&2; exit 2; }
    cmake --build build/release --target benchmarks vitrine vitrine_oiio stability_sdf stability_noise stability_cases stability_scan >&2
    while read -r name kind command <&3; do
        measure "$name" "$kind" "$command" || left="$left $name"
    done 3<"$part/chosen"
    [ -z "$left" ] || { echo "results.sh: not made:$left." >&2; return 1; }
}
main "$@"; exit
