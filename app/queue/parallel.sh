#!/bin/sh
# parallel.sh PARTS VITRINE-COMMAND...: makes a recording, print or study in so many parts by GNU parallel, as many at once
# as there are processors (PARALLEL_JOBS=N: N at once), and puts them together.
#   sh app/queue/parallel.sh 8 record hall --seconds 20 --out hall.mp4
# VITRINE=PATH: the program; otherwise `vitrine` of the PATH.
set -e
if ! command -v parallel >/dev/null 2>&1; then
    echo "parallel.sh: GNU parallel is missing (Debian: apt-get install parallel)" >&2
    exit 1
fi
. "$(dirname "$0")/arguments.sh"
parts=$1
shift
# Parallel stops at the first part that fails; `merge` then says which ones to make again.
failed=0
seq "$parts" | parallel --will-cite --jobs "${PARALLEL_JOBS:-100%}" --quote "$program" "$@" --shard "{}/$parts" || failed=$?
"$program" merge "$out" || exit $?
exit "$failed"
