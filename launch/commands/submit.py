"""Prepares a case and hands it to a cluster: writes DIR/job.slurm (and DIR/job.pbs, a template),
submits with sbatch where there is one, and prints how to watch the job.

Before the time limit the job is warned (--warning): both programs write a checkpoint at the end of
the window and leave, with history, summary and report as far as they came. The job then submits
itself again and goes on from the checkpoint, until the end time is reached (--no-resubmit: never).
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess

from launch import slurm_script
from launch.commands import run
from launch.errors import InputError, RunError
from launch.prepare import Prepared
from launch.progress import say

NAME = "submit"
HELP = "prepare a case and submit it to Slurm (or write the job script)"
SHORTEST_S = 60  # a job has to have this long before the warning


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `submit`."""
    run.case_arguments(parser)
    parser.add_argument("--nodes", metavar="N", type=run.positive, default=1, help="nodes (default 1)")
    parser.add_argument("--time", metavar="LIMIT", type=seconds, default="1:00:00",
                        help="time limit, [D-]HH:MM:SS (default 1:00:00)")
    parser.add_argument("--warning", metavar="S", type=run.positive, default=120,
                        help="seconds before the limit at which the programs are asked to leave; "
                             "longer than a window takes (default 120)")
    parser.add_argument("--memory", metavar="SIZE", type=memory, help="memory a node, e.g. 8G")
    parser.add_argument("--partition", metavar="NAME", type=word, help="partition, or queue")
    parser.add_argument("--account", metavar="NAME", type=word, help="account to charge")
    parser.add_argument("--launcher", choices=("mpirun", "srun"), default="mpirun",
                        help="what starts the programs: mpirun (default), or srun --multi-prog")
    parser.add_argument("--no-resubmit", action="store_true",
                        help="one job: what its time does not suffice for can be submitted by hand")
    parser.add_argument("--dry-run", action="store_true", help="write everything, submit nothing")


def seconds(text: str) -> int:
    """Seconds of a time limit written as [D-]HH:MM:SS."""
    found = re.fullmatch(r"(?:(\d+)-)?(\d+):([0-5]\d):([0-5]\d)", text)
    if not found:
        raise argparse.ArgumentTypeError("write the limit as [D-]HH:MM:SS, e.g. 12:00:00")
    days, *rest = (int(part or 0) for part in found.groups())
    return ((days * 24 + rest[0]) * 60 + rest[1]) * 60 + rest[2]


def memory(text: str) -> str:
    """An amount of memory with its unit."""
    if not re.fullmatch(r"[1-9]\d*[KMGT]", text):
        raise argparse.ArgumentTypeError("write a whole number with K, M, G or T, e.g. 8G")
    return text


def word(text: str) -> str:
    """A name without blanks, as the schedulers take it."""
    if not re.fullmatch(r"[\w.,+-]+", text):
        raise argparse.ArgumentTypeError("write a plain name")
    return text


def main(options: argparse.Namespace) -> int:
    """Runs the command; exit status 1 where sbatch refuses the job."""
    if options.time < options.warning + SHORTEST_S:
        raise InputError("command line", "--time", options.time,
                         f"seconds are too few with a warning {options.warning} s before the end; give at "
                         f"least {options.warning + SHORTEST_S} s, or a smaller --warning")
    ready = run.make_ready(options)
    name = re.sub(r"[^\w.-]", "_", ready.directory.name)
    tasks = ready.ranks_fluid + ready.ranks_dem
    nodes = min(options.nodes, tasks)
    if nodes < options.nodes:
        say(f"{tasks} ranks in all: {nodes} nodes are enough (--ranks-fluid, --ranks-dem for more)")
    job = slurm_script.Job(name, nodes, tasks, options.time, options.warning,
                           options.memory, options.partition, options.account, options.launcher,
                           not options.no_resubmit)
    script = ready.directory / "job.slurm"
    script.write_text(slurm_script.slurm(job, ready))
    script.with_suffix(".pbs").write_text(slurm_script.pbs(job, ready))
    say(f"{ready.ranks_fluid} + {ready.ranks_dem} ranks on {nodes} "
        f"node{'s' if nodes > 1 else ''}, {job.walltime}: {script}")
    if options.dry_run or shutil.which("sbatch") is None:
        _explain(ready, options.dry_run)
        return 0
    _submit(ready)
    return 0


def _explain(ready: Prepared, asked: bool) -> None:
    if not asked:
        say("no sbatch on this machine: nothing was submitted")
    say(f"where Slurm is:  sbatch {ready.directory / 'job.slurm'}")
    say(f"where PBS is:    qsub {ready.directory / 'job.pbs'}   (a template: adapt its head to the site)")
    say("paths and modules are variables at the top of both files")


def _submit(ready: Prepared) -> None:
    done = subprocess.run(["sbatch", "--parsable", str(ready.directory / "job.slurm")],
                          capture_output=True, text=True, check=False)
    if done.returncode:
        raise RunError(f"sbatch refused {ready.directory / 'job.slurm'}: {done.stderr.strip()}")
    number = done.stdout.strip().split(";")[0]
    log = ready.directory / f"job-{number}.log"
    say(f"submitted as job {number}")
    say(f"  watch:   squeue -j {number}; tail -f {log}; tail -n 1 {ready.directory / 'history.csv'}")
    say(f"  leave at the next window's end:  scancel --batch --signal=USR1 {number}")
    say(f"  stop at once:                    scancel {number}")
