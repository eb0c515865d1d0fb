#!/bin/sh
# slurm_array.sh PARTS VITRINE-COMMAND...: hands a recording, print or study to Slurm as a job array of so many parts, and
# a job that puts them together once all have ended, or names those that failed. All nodes must see the folder of OUT.
#   sh app/queue/slurm_array.sh 64 study fur shellCount --out studies/shells
# VITRINE=PATH: the program; SBATCH_OPTIONS="--time=1:00:00 --gres=gpu:1": for the array. Parts that were drawn by
# different renderers are not merged: ask for nodes of one kind.
set -e
if ! command -v sbatch >/dev/null 2>&1; then
    echo "slurm_array.sh: sbatch is missing; this is no machine of a Slurm cluster" >&2
    exit 1
fi
. "$(dirname "$0")/arguments.sh"
parts=$1
shift
# quoted WORD...: as a shell reads them back.
quoted() {
    for word in "$@"; do
        printf " '%s'" "$(printf %s "$word" | sed "s/'/'\\\\''/g")"
    done
}
# shellcheck disable=SC2086
array=$(sbatch --parsable ${SBATCH_OPTIONS:-} --job-name=vitrine --array="1-$parts" \
    --wrap="$(quoted "$program" "$@") --shard \$SLURM_ARRAY_TASK_ID/$parts")
merge=$(sbatch --parsable --job-name=vitrine-merge --dependency="afterany:${array%%;*}" \
    --wrap="$(quoted "$program" merge "$out")")
echo "parts: job $array, then merging: job $merge"
