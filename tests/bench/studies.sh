#!/bin/sh
# Measures again what accuracy costs: studies of the headline parameters of each exhibit, whose numbers and charts
# go to tests/bench/results as study_EXHIBIT_PARAMETER, and whose sentences stand in the exhibit's README. Prints them.
#   sh tests/bench/studies.sh                   all
#   sh tests/bench/studies.sh sdf_morph fur     those
# The whole studies, with pictures and pages, stay in build/studies.
set -e
cd "$(dirname "$0")/../.."
program=build/release/vitrine
results=tests/bench/results
mkdir -p build/studies

# measure EXHIBIT PARAMETER... [OPTION...]
measure() {
    case "$wanted" in
        "" | *" $1 "*) ;;
        *) return 0 ;;
    esac
    name=""
    for word in "$@"; do
        case "$word" in -*) break ;; esac
        name=${name:+${name}_}$word
    done
    "$program" study "$@" --out "build/studies/$name" >"build/studies/$name.txt"
    cp "build/studies/$name/study.csv" "$results/study_$name.csv"
    cp "build/studies/$name/chart.svg" "$results/study_$name.svg"
    # A choice follows no law: what each of its methods errs by.
    echo "$name: $(grep -i 'halving' "build/studies/$name.txt" ||
        awk -v row="$2 " 'index($0, row) == 1 { printf "%s%s errs by %s", between, trimmed(substr($0, length(row) + 1, 44 - length(row))), substr($0, 45, 13) + 0; between = "; " }
                          function trimmed(text) { sub(/ +$/, "", text); return text }' "build/studies/$name.txt")"
}

wanted=""
[ $# -eq 0 ] || wanted=" $* "
measure sdf_morph hitTolerance
measure lenticular apertureSamples
measure fur shellCount --set levelOfDetail=off
measure fur rotationModel --views 6
measure fur springModel --views 6
measure crepuscular_rays volumeSteps
measure crepuscular_rays method samples --points 6 --runs 3 --set technique="screen space" --set resolution=full
measure hall supersamples --values 1,2,4,8,16,32 --size 160x90 --views 1
measure sdf_morph hall.supersamples --alone --values 1,2,4,8,16,32,64 --size 160x90 --views 1
