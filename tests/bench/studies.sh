#!/bin/sh
# Measures again what accuracy costs: one study of the headline parameter of each exhibit, whose numbers and chart
# go to tests/bench/results, and whose sentence stands in the exhibit's README. Prints the sentences.
#   sh tests/bench/studies.sh                   all
#   sh tests/bench/studies.sh sdf_morph fur     those
# The whole studies, with pictures and pages, stay in build/studies.
set -e
cd "$(dirname "$0")/../.."
program=build/release/vitrine
results=tests/bench/results
mkdir -p build/studies

# measure EXHIBIT PARAMETER [OPTION...]
measure() {
    exhibit=$1
    case "$wanted" in
        "" | *" $exhibit "*) ;;
        *) return 0 ;;
    esac
    "$program" study "$@" --out "build/studies/$exhibit" >"build/studies/$exhibit.txt"
    cp "build/studies/$exhibit/study.csv" "$results/study_$exhibit.csv"
    cp "build/studies/$exhibit/chart.svg" "$results/study_$exhibit.svg"
    echo "$exhibit, $2: $(grep '^Halving' "build/studies/$exhibit.txt" || grep -m1 'reference' "build/studies/$exhibit.txt")"
}

wanted=""
[ $# -eq 0 ] || wanted=" $* "
measure sdf_morph hitTolerance
measure lenticular apertureSamples
measure fur shellCount --set levelOfDetail=off
measure crepuscular_rays volumeSteps
measure hall supersamples --values 1,2,4,8,16 --size 160x90
