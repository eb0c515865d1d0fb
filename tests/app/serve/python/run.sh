#!/bin/sh
# run.sh PROGRAM TEST: runs one of the tests here with the built program, by a Python that has numpy. 77: there is none.
here=$(cd "$(dirname "$0")" && pwd) || exit 2
for python in python3 /usr/bin/python3; do
    "$python" -c "import numpy" 2>/dev/null || continue
    VITRINE_PROGRAM=$1
    PYTHONPATH=$here/../../../../app/serve/python:$here
    # Python writes no compiled files: the source tree stays unchanged.
    PYTHONDONTWRITEBYTECODE=1
    export VITRINE_PROGRAM PYTHONPATH PYTHONDONTWRITEBYTECODE
    exec "$python" "$here/$2.py"
done
echo "numpy is not here (python3-numpy)"
exit 77
