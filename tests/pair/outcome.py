"""One run of a fault matrix: how it ended, and what it told."""

import os
import re
import shutil
import subprocess
import time


class Outcome:
    """How a run ended: seconds (from `strike`, where something is done to the running job), status, output."""

    def __init__(self, line, strike=None):
        start = time.monotonic()
        job = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                               env=dict(os.environ, WM_PROJECT_DIR="/usr/share/openfoam"))
        if strike:
            strike(job)
            start = time.monotonic()
        self.text = job.communicate(timeout=100)[0]
        self.seconds, self.status = time.monotonic() - start, job.returncode

    def reason(self, words):
        """The line that names the reason, without the directory."""
        for text in self.text.splitlines():
            if any(word in text for word in words):
                text = re.sub(r"^slidewave: |^mpirun noticed that ", "", text.strip())
                return re.sub(r"PID \d+ on node \S+ ", "", re.sub(r"(/[\w.-]+)+/(?=[\w.]+)", "", text))
        return None


def fresh(work, name):
    """An empty directory."""
    directory = work / name.replace(" ", "_")
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    return directory
