# Sourced by the scripts of queues with their own arguments, PARTS VITRINE-COMMAND... --out OUT (or --out=OUT): sets `out` and `program`.
if [ $# -lt 3 ]; then
    echo "usage: $(basename "$0") PARTS VITRINE-COMMAND... --out OUT" >&2
    exit 2
fi
out=""
last=""
for word in "$@"; do
    [ "$last" = --out ] && out=$word
    case "$word" in --out=*) out=${word#--out=} ;; esac
    last=$word
done
if [ -z "$out" ]; then
    echo "$(basename "$0"): --out is missing" >&2
    exit 2
fi
program=${VITRINE:-vitrine}
