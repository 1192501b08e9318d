"""`slidewave submit`: what the job scripts hold, that bash takes them, that sbatch is called, and
that a script run by bash alone ends both programs on the warning. Shell scripts stand in for sbatch
and for the two programs."""

import os
import signal
import subprocess
import time
from pathlib import Path
from unittest import main, mock

from tests.launch.scratch import ScratchCase

WAIT = ("trap 'echo asked >> \"$1/asked\"; exit 0' USR1; touch \"$1/up\"\n"
        "i=0; while [ $i -lt 600 ]; do sleep 0.1; i=$((i+1)); done; exit 3")
LEAVES_A_CHECKPOINT = ("trap 'mkdir -p \"$1/checkpoints/00000007\"; "
                       "touch \"$1/checkpoints/00000007/manifest.json\"; "
                       "printf \"window,time_s,sphere_vz_m_s\\n0,0,0\\n\" >\"$1/history.csv\"; "
                       "printf \"{\\n  \\\"status\\\": \\\"stopped\\\"\\n}\" >\"$1/summary.json\"; exit 0' USR1\n"
                       "i=0; while [ $i -lt 600 ]; do sleep 0.1; i=$((i+1)); done; exit 3")
SBATCH = "echo \"$@\" > \"$(dirname \"$0\")/called\"; cat \"$2\" > /dev/null && echo '4711;cluster'"


class Submit(ScratchCase):
    def setUp(self) -> None:
        super().setUp()
        self.out, self.bin = self.place / "run", self.place / "bin"
        self.bin.mkdir()
        environment = {"SLIDEWAVE_BUILD": str(self.place), "PATH": f"{self.bin}:{os.environ['PATH']}"}
        patch = mock.patch.dict(os.environ, environment)
        patch.start()
        self.addCleanup(patch.stop)

    def program(self, name: str, text: str) -> None:
        (self.bin / name).write_text(f"#!/bin/sh\n{text}\n")
        (self.bin / name).chmod(0o755)

    def submit(self, *more: str) -> str:
        """Standard output of `submit` of the quick variant."""
        status, text, err = self.slidewave("submit", self.case, "--variant", "uniform", "--out", self.out,
                                           "--ranks-fluid", "2", "--ranks-dem", "1", *more)
        self.assertEqual(status, 0, text + err)
        return text

    def script(self, name: str = "job.slurm") -> str:
        subprocess.run(["bash", "-n", str(self.out / name)], check=True)
        return (self.out / name).read_text()

    def test_values_appear(self) -> None:
        text = self.submit("--dry-run", "--nodes", "2", "--time", "1-02:03:04", "--memory", "8G",
                           "--partition", "short", "--account", "rock", "--warning", "300")
        self.assertIn("sbatch " + str(self.out / "job.slurm"), text)
        script = self.script()
        for line in ("--job-name=run", "--nodes=2", "--ntasks=3", "--time=26:03:04", "--mem=8G",
                     "--partition=short", "--account=rock", "--signal=B:USR1@300", "--no-requeue"):
            self.assertIn(f"#SBATCH {line}\n", script)
        self.assertIn('-np 2 "$BIN/slidewave_uniform" "$RUN" : -np 1 "$BIN/slidewave_dem" "$RUN"', script)
        self.assertIn('"0-1 $BIN/slidewave_uniform $RUN" "2 $BIN/slidewave_dem $RUN"', script)
        self.assertIn("RESUBMIT=(sbatch --parsable)", script)
        self.assertIn("TIME_S=93784\n", script)
        self.assertNotIn("@R", script)
        pbs = self.script("job.pbs")
        for line in ("-l select=2:ncpus=2:mpiprocs=2:mem=8gb", "-l walltime=26:03:04", "-q short"):
            self.assertIn(f"#PBS {line}\n", pbs)
        self.assertTrue((self.out / "case.toml").is_file() and (self.out / "dem/parameters").is_file())

    def test_no_empty_requests(self) -> None:
        self.submit("--dry-run")
        for word in ("--mem", "--partition", "--account"):
            self.assertNotIn(f"#SBATCH {word}", self.script())

    def test_sbatch_is_called(self) -> None:
        self.program("sbatch", SBATCH)
        text = self.submit()
        self.assertEqual((self.bin / "called").read_text(), f"--parsable {self.out / 'job.slurm'}\n")
        for expected in ("job 4711", "squeue -j 4711", "scancel 4711", str(self.out / "job-4711.log")):
            self.assertIn(expected, text)

    def test_sbatch_refuses(self) -> None:
        self.program("sbatch", "echo 'invalid partition' >&2; exit 1")
        status, _, err = self.slidewave("submit", self.case, "--out", self.out, "--variant", "uniform")
        self.assertEqual(status, 1)
        self.assertIn("invalid partition", err)

    def test_without_sbatch(self) -> None:
        with mock.patch("shutil.which", return_value=None):
            self.assertIn("nothing was submitted", self.submit())

    def test_bad_arguments(self) -> None:
        for words in (["--time", "90"], ["--time", "1:60:00"], ["--time", "0:02:00"], ["--memory", "8 G"],
                      ["--nodes", "0"], ["--partition", "a b"], ["--launcher", "ssh"]):
            with self.subTest(words=words):
                status, _, err = self.slidewave("submit", self.case, "--out", self.out, *words)
                self.assertEqual(status, 2, err)
                self.assertIn(words[0], err)
                self.assertFalse(self.out.exists(), "a refused job left a run directory")

    def run_script(self, name: str = "job.slurm") -> subprocess.Popen:
        child = subprocess.Popen(["bash", str(self.out / name)], stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True)
        self.addCleanup(lambda: child.poll() is None and child.kill())
        return child

    def await_file(self, path: Path) -> None:
        end = time.monotonic() + 30
        while not path.exists():
            self.assertLess(time.monotonic(), end, f"{path} did not appear")
            time.sleep(0.05)

    def test_warning_reaches_both_programs(self) -> None:
        self.program("slidewave_uniform", WAIT)
        self.program("slidewave_dem", WAIT)
        self.submit("--dry-run", "--ranks-fluid", "1")
        self.allow_more_ranks_than_cores()
        child = self.run_script()
        self.await_file(self.out / "up")
        time.sleep(0.5)
        child.send_signal(signal.SIGUSR1)
        text = child.communicate(timeout=30)[0]
        self.assertEqual(child.returncode, 0, text)
        self.assertIn("asked to stop", text)
        self.assertEqual((self.out / "asked").read_text(), "asked\nasked\n")

    def test_goes_on_in_another_job(self) -> None:
        """Stopped with a new checkpoint: submitted again, from there; not where nothing was gained."""
        self.program("slidewave_uniform", WAIT)
        self.program("slidewave_dem", LEAVES_A_CHECKPOINT)
        self.program("sbatch", SBATCH)
        self.submit("--dry-run", "--ranks-fluid", "1", "--time", "0:02:00", "--warning", "60")
        self.allow_more_ranks_than_cores()
        for number in (1, 2):
            child = self.run_script()
            self.await_file(self.out / "up")
            time.sleep(0.5)
            child.send_signal(signal.SIGUSR1)
            text = child.communicate(timeout=30)[0]
            self.assertEqual(child.returncode, 0, text)
            self.assertEqual((self.bin / "called").exists(), number == 1, text)
            if number == 1:
                self.assertIn("goes on as job 4711", text)
                self.assertEqual((self.bin / "called").read_text(), f"--parsable {self.out / 'job.slurm'}\n")
                (self.bin / "called").unlink()
                (self.out / "up").unlink()

    def test_no_resubmit(self) -> None:
        self.submit("--dry-run", "--no-resubmit")
        self.assertIn("RESUBMIT=()", self.script())
        self.submit("--dry-run", "--overwrite")
        self.assertIn("RESUBMIT=(qsub)", self.script("job.pbs"))

    def test_status_and_report(self) -> None:
        for status in (0, 1):
            self.program("slidewave_uniform", "exit 0")
            self.program("slidewave_dem", f"printf 'window,time_s,sphere_vz_m_s\\n0,0,0\\n1,1,-1\\n' "
                                          f">\"$1/history.csv\"; exit {status}")
            self.submit("--dry-run", "--overwrite", "--ranks-fluid", "1")
            self.allow_more_ranks_than_cores()
            child = self.run_script("job.pbs" if status else "job.slurm")
            text = child.communicate(timeout=60)[0]
            self.assertEqual(child.returncode, status, text)
            self.assertTrue((self.out / "report.html").is_file(), text)
        again = self.run_script()
        self.assertIn("holds a result", again.communicate(timeout=30)[0])
        self.assertEqual(again.returncode, 2)

    def test_an_mpirun_that_stays_is_ended(self) -> None:
        """With the status that the programs wrote; one that is killed for another reason keeps its own."""
        leave = "import os, subprocess, time; dead = subprocess.Popen([\"true\"]); "
        for written, last, status in (("completed", "time.sleep(60)", 0), ("failed", "time.sleep(60)", 1),
                                      ("completed", "os.kill(os.getpid(), 9)", 137)):
            self.program("mpirun", f"exec /usr/bin/python3 -c '{leave}{last}'")
            self.submit("--dry-run", "--overwrite")
            (self.out / "summary.json").write_text(f'{{\n  "status": "{written}"\n}}')
            script = self.script()
            self.assertIn("LOOK_S=5 ", script)
            (self.out / "job.slurm").write_text(script.replace("LOOK_S=5 ", "LOOK_S=0.3 "))
            start = time.monotonic()
            child = self.run_script()
            text = child.communicate(timeout=40)[0]
            self.assertEqual(child.returncode, status, text)
            self.assertLess(time.monotonic() - start, 30)
            self.assertEqual("did not leave" in text, last.startswith("time"), text)

    def allow_more_ranks_than_cores(self) -> None:
        """A cluster has the cores that were asked for; this machine may not."""
        for name in ("job.slurm", "job.pbs"):
            text = (self.out / name).read_text()
            self.assertIn("MPIRUN=(mpirun ", text)
            (self.out / name).write_text(text.replace("MPIRUN=(mpirun ", "MPIRUN=(mpirun --oversubscribe "))


if __name__ == "__main__":
    main()
