#!/bin/sh
# Measures this machine within eight minutes and prints the report, in Markdown; arguments go to the program:
#   ./run-benchmarks --minutes 3 >report.md
# Nothing else should run meanwhile. Without a display, the start of the window is left out.
VITRINE_PORTABLE_PROGRAM=benchmarks exec timeout 600 sh "$(dirname "$(readlink -f "$0")")/vitrine" portable "$@"
