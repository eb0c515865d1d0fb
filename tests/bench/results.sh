#!/bin/sh
# Makes the files of tests/bench/results: each is the unedited output of one command, below a head that says which command
# at which commit, when, on what, how loaded, and how fast a plain copy of memory was before and after. Then brings the
# excerpts in the READMEs up to date. The machine should do nothing else meanwhile.
#   sh tests/bench/results.sh                             all of them: about a quarter of an hour on two cores
#   sh tests/bench/results.sh hall_costs study_fur_*      those, by name or pattern
#   sh tests/bench/results.sh --missing                   all that are not of this commit yet: goes on after an interruption
#   sh tests/bench/results.sh hall_costs -- --rounds 3    with options of the command's own, for a smaller run, which is not to be committed
#   sh tests/bench/results.sh --list                      name, what it draws with, and command of each; measures nothing
#   sh tests/bench/results.sh readme                      only the excerpts
set -e
cd "$(dirname "$0")/../.."
results=tests/bench/results
tests=build/release/tests
study="build/release/vitrine study"

# One line each: the file's name, whether it is drawn ("gl", and the file's name says with what) or only computed ("cpu"), and
# the command.
entries() {
    cat <<END
sdf_evaluations cpu $tests/bench_sdf_evaluations
interlacing cpu $tests/bench_interlacing
large_print cpu $tests/bench_large_print
window_start gl xvfb-run -a $tests/bench_window_start
window_latency gl xvfb-run -a -s -screen\ 0\ 1600x1000x24 $tests/bench_window_latency
fur_costs gl $tests/bench_fur_costs
shadow_filters gl $tests/bench_shadow_filters
sunbeams gl $tests/bench_sunbeams
noise_costs gl $tests/bench_noise_costs
scene_speed gl $tests/bench_scene_speed
pixel_normals gl $tests/bench_pixel_normals --model assets/models/teddy.glb
hall_costs gl $tests/bench_hall_costs
motion gl $tests/bench_motion
web_hall gl sh tests/bench/web_hall.sh
study_sdf_morph_hitTolerance gl $study sdf_morph hitTolerance
study_lenticular_apertureSamples gl $study lenticular apertureSamples
study_fur_shellCount gl $study fur shellCount --set levelOfDetail=off
study_fur_rotationModel gl $study fur rotationModel --views 6 --runs 3
study_fur_springModel gl $study fur springModel --views 6 --runs 3
study_crepuscular_rays_volumeSteps gl $study crepuscular_rays volumeSteps
study_crepuscular_rays_method_samples gl $study crepuscular_rays method samples --points 6 --runs 3 --set technique=screen\ space --set resolution=full
study_ice_cream_hitTolerance gl $study ice_cream hitTolerance
study_ice_cream_normalStep gl $study ice_cream normalStep
study_ice_cream_shadowMethod_stepLimit gl $study ice_cream shadowMethod stepLimit --points 5 --runs 3
study_ice_cream_occlusionTaps gl $study ice_cream occlusionTaps --alone --set lighting=as\ in\ the\ source
study_ice_cream_supersamples gl $study ice_cream hall.supersamples --alone --values 1,2,4,8,16 --size 96x54 --views 1 --runs 3
study_noise_boundShare gl $study noise boundShare --set work=fractal\ sum --points 6 --runs 3
study_noise_octaves gl $study noise octaves --set work=fractal\ sum --points 6 --runs 3
study_noise_normals gl $study noise normals --set work=fractal\ sum --runs 3
study_noise_fieldNoise gl $study noise fieldNoise --set work=field --runs 3
study_noise_cloudSteps gl $study noise cloudSteps --set work=clouds --points 6 --runs 3
study_noise_lightSteps gl $study noise lightSteps --set work=clouds --points 6 --runs 3
study_noise_bakeSize gl $study noise bakeSize --set work=clouds --values 16,32,64,96,160 --runs 3
study_noise_waves gl $study noise waves --set work=sea --points 6 --runs 3
study_noise_seaSteps gl $study noise seaSteps --set work=sea --points 6 --runs 3
study_paper_lanterns_repetition gl $study paper_lanterns repetition --runs 3
study_paper_lanterns_bounces gl $study paper_lanterns bounces --set waveHeight=2 --runs 3
study_paper_lanterns_waterSteps gl $study paper_lanterns waterSteps --points 6 --runs 3
study_paper_lanterns_rippleCount gl $study paper_lanterns rippleCount --points 6 --runs 3
study_paper_lanterns_lightCells gl $study paper_lanterns lightCells --points 5 --runs 3
study_paper_lanterns_rows_pointSize gl $study paper_lanterns rows pointSize --points 5 --runs 3
study_paper_lanterns_supersamples gl $study paper_lanterns hall.supersamples --alone --values 1,2,4,8,16 --size 160x90 --views 1 --runs 3
study_pixel_art_method gl $study pixel_art method --runs 3
study_pixel_art_depthBits gl $study pixel_art depthBits --runs 3
study_hall_supersamples gl $study hall supersamples --values 1,2,4,8,16,32 --size 160x90 --views 1
study_hall_historyFrames gl $study hall historyFrames --values 1,2,4,8,16,32 --size 320x180 --views 2 --runs 3
study_sdf_morph_supersamples gl $study sdf_morph hall.supersamples --alone --values 1,2,4,8,16,32,64 --size 160x90 --views 1
stability_suite gl env VITRINE_SCAN_PRESETS=100 ctest --test-dir build/release -L stability -j 2
END
    for scene in primitives ambient_occlusion mercury; do
        for varied in shadowMethod\ shadowRays occlusionMethod\ occlusionRays bounces hitTolerance normalStep; do
            name=$(echo "$varied" | tr ' ' '_')
            echo "study_sdf_scenes_${name}_$scene gl $study sdf_scenes $varied --points 5 --runs 3 --alone --size 160x90 --views 2 --set scene=$scene.json"
        done
    done
}

# field NAME: what bench_machine said.
field() { printf '%s\n' "$machine" | sed -n "s/^$1	//p"; }

# "llvmpipe (LLVM 15.0.6, 256 bits), ..." is llvmpipe; "NVIDIA H200/PCIe/SSE2, ..." is nvidia-h200.
slug() { printf '%s\n' "$1" | sed 's/[(,\/].*//; s/[^A-Za-z0-9]\{1,\}/-/g; s/-$//' | tr '[:upper:]' '[:lower:]'; }

row() { printf '| %s | %s |\n' "$1" "$2"; }

# The results and the excerpts are what a run changes: they make no commit another one.
changes() { git status --porcelain -- . ':!tests/bench/results' ':!README.md' ':!tests/bench/README.md' ':!exhibits/*/README.md'; }

measure() {
    name=$1 kind=$2 command=$3
    machine=$($tests/bench_machine) || return 1
    file=$name
    [ "$kind" = cpu ] || file=$name-$(slug "$(field renderer)")
    if [ -n "$missing" ] && [ -z "$(changes)" ] && grep -qs "^| commit | $commit |$" "$results/$file.md"; then return 0; fi
    echo "$name: $command" >&2
    format=markdown
    case $name in study_* | sdf_evaluations | stability_suite) format=text ;; esac
    case $name in
    study_*) set -- --out "build/studies/$name" ;;
    *) set -- ;;
    esac
    started=$(date +%s)
    # Split as it stands: no word of a command has a blank in it but for "screen space", which the list escapes.
    eval "$command \"\$@\"" >"$part/out" 2>"$part/err" </dev/null || { cat "$part/out" "$part/err" >&2; echo "$name: the command failed; its file stays as it was." >&2; return 1; }
    took=$(($(date +%s) - started))
    {
        echo "# $name"
        echo
        echo "Made by \`sh tests/bench/results.sh\`; what it says is explained in [the README](../README.md)."
        echo
        echo "| made with | |"
        echo "|---|---|"
        row command "\`$command\`"
        row commit "$commit${dirty:+, $dirty}"
        row date "$(date -u '+%Y-%m-%d %H:%M UTC')"
        if [ "$kind" = cpu ]; then row renderer none; else row renderer "$(field renderer)"; fi
        row processor "$(field processor)"
        row "load before" "$(field load)"
        row memcpy "$(field memcpy) GB/s before, $($tests/bench_machine memcpy | cut -f 2) GB/s after"
        row took "$took s"
        row output "cksum $(cksum <"$part/out")"
        echo
        echo "---"
        if [ "$format" = text ]; then printf '```\n'; fi
        cat "$part/out"
        if [ "$format" = text ]; then printf '```\n'; fi
    } >"$part/file"
    mv "$part/file" "$results/$file.md"
}

# Puts the lines of results between <!-- from FILE "SECTION" "START"... --> and <!-- end -->: those that begin with one of
# the STARTs, word for word, in the file's order. A SECTION begins with # and ends at the next heading; it may be left out.
# Nothing where the file has not been made yet.
excerpts() {
    failed=""
    for readme in README.md tests/bench/README.md exhibits/*/README.md; do
        awk -v readme="$readme" '
            /^<!-- end -->$/ { inside = 0 }
            !inside { print }
            /^<!-- from / {
                inside = 1
                split($0, words, "\"")
                file = words[1]; sub(/^<!-- from /, "", file); sub(/ *(-->)?$/, "", file)
                section = ""; starts = 0
                for (i = 2; i in words && (i + 1) in words; i += 2)
                    if (words[i] ~ /^#/ && i == 2) section = words[i]; else start[++starts] = words[i]
                within = section == ""; found = 0
                more = 0
                while ((got = (getline line < file)) > 0) {
                    more = 1
                    if (section != "" && line ~ /^#/) within = line == section
                    if (!within) continue
                    for (i = 1; i <= starts; ++i) if (index(line, start[i]) == 1) { print line; ++found; break }
                }
                close(file)
                if (!found && more) { print readme ": nothing found for " $0 > "/dev/stderr"; bad = 1 }
            }
            END { exit bad }' "$readme" >"$part/readme" || failed=yes
        cmp -s "$part/readme" "$readme" || cat "$part/readme" >"$readme"
    done
    [ -z "$failed" ]
}

# In a function, so that all of this is read before it runs: the script may change while it does.
main() {
    part=$(mktemp -d)
    trap 'rm -rf "$part"' EXIT
    case ${1:-} in
    --list) entries; return ;;
    readme) excerpts; return ;;
    esac
    missing="" wanted="" options="" left=""
    while [ $# -gt 0 ]; do
        case $1 in
        --missing) missing=yes ;;
        --) shift; options=" $*"; break ;;
        *) wanted="$wanted $1" ;;
        esac
        shift
    done
    mkdir -p "$results" build/studies
    commit=$(git rev-parse HEAD)
    [ -z "$(changes)" ] && dirty="" || dirty="with uncommitted changes"
    targets="vitrine vitrine_oiio bench_machine"
    set -f
    entries | while read -r name kind command; do
        for pattern in ${wanted:-"*"}; do
            # shellcheck disable=SC2254
            case $name in $pattern) printf '%s %s %s\n' "$name" "$kind" "$command"; break ;; esac
        done
    done >"$part/chosen"
    set +f
    [ -s "$part/chosen" ] || { echo "results.sh: there is no$wanted; --list tells the names." >&2; exit 2; }
    while read -r name kind command; do
        case $command in
        *bench_*) targets="$targets bench_$name" ;;
        *web_hall*) targets="$targets bench_hall_costs" ;;
        *ctest*) targets="$targets stability_sdf stability_cases stability_scan" ;;
        esac
    done <"$part/chosen"
    # shellcheck disable=SC2086
    cmake --build build/release --target $targets >"$part/build" 2>&1 || { tail -n 20 "$part/build" >&2; exit 1; }
    while read -r name kind command <&3; do
        measure "$name" "$kind" "$command$options" || left="$left $name"
    done 3<"$part/chosen"
    excerpts || left="$left readme"
    [ -z "$left" ] || { echo "results.sh: not made:$left." >&2; return 1; }
}
main "$@"; exit
