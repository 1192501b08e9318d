"""Text of a job script: one MPMD run of both programs under Slurm (job.slurm) or PBS (job.pbs).

Only the head differs. The body forwards a warning before the time limit to both programs, which
write a checkpoint at the end of the window and leave; the job then submits itself again and goes on
from there, until the end time is reached.
"""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from pathlib import Path

from launch import places
from launch.prepare import Prepared
from launch.ranks import sides


@dataclass
class Job:
    """What a job asks for: name, nodes, tasks of all nodes, time limit and warning before it [s],
    memory a node, partition or queue and account (None: the site's own), launcher (mpirun, srun),
    whether it goes on in another job where its time was too short."""

    name: str
    nodes: int
    tasks: int
    time_s: int
    warning_s: int
    memory: str | None = None
    partition: str | None = None
    account: str | None = None
    launcher: str = "mpirun"
    resubmit: bool = True

    @property
    def walltime(self) -> str:
        """The time limit as HH:MM:SS."""
        minutes, seconds = divmod(self.time_s, 60)
        return f"{minutes // 60:02d}:{minutes % 60:02d}:{seconds:02d}"


BODY = """
# Written by slidewave submit. This file and the directory below are all that the job needs.
# Before the time limit both programs write a checkpoint and leave; the job then submits itself again
# and goes on from there. Submitted by hand it goes on too.

# ---- paths and modules of the cluster: change them here --------------------------------------
MODULES=()  # for example: MODULES=(openmpi/4.1 openfoam/1912)
RUN=@RUN@
BIN=@BIN@
SOURCE=@SOURCE@  # for the report alone
PYTHON=@PYTHON@
LAUNCHER=@LAUNCHER@  # mpirun, or srun where Slurm brings PMIx
MPIRUN=(mpirun --bind-to none --mca mpi_yield_when_idle 1)
SRUN=(srun --mpi=pmix --ntasks=@TASKS@)
RESUBMIT=(@RESUBMIT@)  # empty: this job is the last one
TIME_S=@TIME@
WARNING_S=@WARNING@  # before the limit: longer than a window and its checkpoint take
LOOK_S=5  # mpirun is ended where all its programs are found dead three times
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
# -----------------------------------------------------------------------------------------------

if [ ${#MODULES[@]} -gt 0 ]; then module load "${MODULES[@]}"; fi
if [ "$(id -u)" = 0 ]; then MPIRUN+=(--allow-run-as-root); fi
newest() { find "$RUN/checkpoints" -name manifest.json 2>/dev/null | sort | tail -n 1; }
begun_at=$(newest)
if [ -e "$RUN/history.csv" ] && [ -z "$begun_at" ]; then
  echo "slidewave: $RUN holds a result and no checkpoint to go on from: prepare another directory" >&2
  exit 2
fi

if [ "$LAUNCHER" = srun ]; then
  printf '%s\\n' @PROGRAMS@ >"$RUN/programs.conf"
  line=("${SRUN[@]}" --multi-prog "$RUN/programs.conf")
else
  line=("${MPIRUN[@]}" @SIDES@)
fi
printf '%s\\n' "${line[*]}"
"${line[@]}" &
child=$!

# Debian 12's mpirun may stay after its programs, and the job with it until its time limit (seen once in
# hundreds of killed runs).
watch() {
  local dead=0 states
  while sleep "$LOOK_S" && kill -0 "$child"; do
    states=$(ps -o stat= --ppid "$child")
    if [ -n "$states" ] && ! grep -qv '^Z' <<<"$states"; then dead=$((dead + 1)); else dead=0; fi
    if [ "$dead" -eq 3 ]; then
      kill -KILL "$child"
      exit 3
    fi
  done
  exit 0
}
watch >/dev/null 2>&1 &
watcher=$!

# A trap interrupts the wait: then wait again. 127: already collected, its status is known.
again=true
asked=false
status=1
# shellcheck disable=SC2317 # called by the traps
forward() {
  again=true
  asked=true
  echo "slidewave: asked to stop at $(date +%T)"
  kill -USR1 "$child" 2>/dev/null
}
trap forward USR1 TERM
@TIMER@
while $again; do
  again=false
  wait "$child"
  code=$?
  [ "$code" -eq 127 ] || status=$code
done
@TIMER_END@
state=$(sed -n 's/^ *"status": *"\\([a-z]*\\)".*/\\1/p' "$RUN/summary.json" 2>/dev/null | head -n 1)
ended=0
if [ "$status" -eq 137 ]; then
  wait "$watcher"
  ended=$?
else
  kill "$watcher" 2>/dev/null
fi
if [ "$ended" -eq 3 ]; then
  echo "slidewave: mpirun did not leave after its programs: ended"
  case $state in
    completed | stopped) [ -e "$RUN/failure.txt" ] && status=1 || status=0 ;;
    *) status=1 ;;
  esac
fi
if [ -x "$PYTHON" ] && [ -d "$SOURCE/launch" ] && [ -f "$RUN/history.csv" ]; then
  (cd "$SOURCE" && "$PYTHON" -m launch report "$RUN") || echo "slidewave: no report was made"
fi

# Left for the time limit (schedulers may warn a minute early), and further than it began: go on.
if $asked && [ "$state" = stopped ] && [ "$(newest)" != "$begun_at" ] && [ ${#RESUBMIT[@]} -gt 0 ] &&
  [ "$SECONDS" -ge $((TIME_S - WARNING_S - 90)) ]; then
  if next=$("${RESUBMIT[@]}" "$RUN/@SCRIPT@"); then
    echo "slidewave: goes on as job $next"
  else
    echo "slidewave: could not be submitted again; by hand: ${RESUBMIT[*]} $RUN/@SCRIPT@" >&2
    status=1
  fi
fi
exit "$status"
"""

# PBS gives no warning itself.
TIMER = """(sleep "$((TIME_S - WARNING_S))" && kill -USR1 "$$") >/dev/null 2>&1 &
timer=$!"""


def slurm(job: Job, ready: Prepared) -> str:
    """Content of job.slurm."""
    output = shlex.quote(str(ready.directory / "job-%j.log"))
    head = [f"--job-name={job.name}", f"--nodes={job.nodes}", f"--ntasks={job.tasks}",
            f"--time={job.walltime}", f"--signal=B:USR1@{job.warning_s}", "--no-requeue",
            f"--output={output}"]
    head += [f"--{name}={value}" for name, value in (
        ("mem", job.memory), ("partition", job.partition), ("account", job.account)) if value]
    return _script("#SBATCH", head, job, ready, timer=False)


def pbs(job: Job, ready: Prepared) -> str:
    """Content of job.pbs, a template: sites differ in what `select` wants."""
    ranks = -(-job.tasks // job.nodes)
    memory = f":mem={job.memory.lower()}b" if job.memory else ""
    head = [f"-N {job.name[:15]}", f"-l select={job.nodes}:ncpus={ranks}:mpiprocs={ranks}{memory}",
            f"-l walltime={job.walltime}", "-j oe", f"-o {ready.directory / 'job.log'}", "-r n"]
    head += [f"-{name} {value}" for name, value in (("q", job.partition), ("A", job.account)) if value]
    return _script("#PBS", head, job, ready, timer=True)


def _script(mark: str, head: list[str], job: Job, ready: Prepared, timer: bool) -> str:
    first, lines, words = 0, [], []
    for ranks, command in sides(ready.directory, ready.ranks_fluid, ready.ranks_dem,
                                ready.fluid_engine, ready.dem_engine):
        name = Path(command[0]).name
        last = first + ranks - 1
        lines.append(f'"{first}{f"-{last}" if ranks > 1 else ""} $BIN/{name} $RUN"')
        words.append(f'-np {ranks} "$BIN/{name}" "$RUN"')
        first += ranks
    values = {"RUN": ready.directory, "BIN": places.program(""), "SOURCE": places.ROOT,
              "PYTHON": "/usr/bin/python3"}
    body = BODY.replace("@TIMER@\n", TIMER + "\n" if timer else "")
    body = body.replace("@TIMER_END@\n", 'kill "$timer" 2>/dev/null\n' if timer else "")
    for name, value in values.items():
        body = body.replace(f"@{name}@", shlex.quote(str(value)))
    for name, value in {"LAUNCHER": job.launcher if not timer else "mpirun", "TASKS": job.tasks,
                        "WARNING": job.warning_s, "TIME": job.time_s,
                        "RESUBMIT": ("qsub" if timer else "sbatch --parsable") if job.resubmit else "",
                        "SCRIPT": "job.pbs" if timer else "job.slurm",
                        "PROGRAMS": " ".join(lines), "SIDES": " : ".join(words)}.items():
        body = body.replace(f"@{name}@", str(value))
    return "\n".join(["#!/bin/bash", *(f"{mark} {entry}" for entry in head)]) + "\n" + body
