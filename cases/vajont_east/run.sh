#!/bin/sh
# The plain mpirun line: run.sh DIR runs what `slidewave run cases/vajont_east --dry-run --out DIR`
# prepared. FLUID and DEM: ranks of each side, as prepared. SLIDEWAVE_BUILD: build directory, default
# build/ of this source tree.
set -eu
dir=${1:?usage: run.sh DIR}
bin=${SLIDEWAVE_BUILD:-$(dirname "$0")/../../build}/bin
root=; [ "$(id -u)" = 0 ] && root=--allow-run-as-root
exec mpirun --bind-to none --mca mpi_yield_when_idle 1 $root --oversubscribe \
  -np "${FLUID:-2}" "$bin/slidewave_foam" "$dir" : -np "${DEM:-2}" "$bin/slidewave_dem" "$dir"
