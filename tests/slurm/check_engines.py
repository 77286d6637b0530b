# SPDX-License-Identifier: BSD-3-Clause
"""A campaign in twelve shards on a real Slurm of one machine, one of which crashes and one hangs; the same by GNU parallel
and one after another. All must end with the rows of one local run: check_engines.py ENGINE NARROWS SOURCES FAULT_PLUGIN FOLDER

Exit code 77: the engine is not installed."""

import os
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import time

SHARDS = 12
MEASURED = {"id", "environmentid", "experimentid", "plannerid", "time", "cpu_time", "simplification_time", "memory"}
MEASURED |= {"peak_memory_kb", "cpus", "shares_core"}
PROGRAMS = {"slurm": ["sbatch", "squeue", "slurmctld", "slurmd", "munged"], "parallel": ["parallel"], "local": []}
PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"


def rows(database):
    connection = sqlite3.connect(database)
    columns = [row[1] for row in connection.execute("PRAGMA table_info(runs)") if row[1] not in MEASURED]
    text = ", ".join("runs." + column for column in columns)
    found = connection.execute(
        f"SELECT experiments.name, plannerConfigs.name, settings, {text} FROM runs"
        " JOIN experiments ON experiments.id = experimentid JOIN plannerConfigs ON plannerConfigs.id = plannerid"
    ).fetchall()
    connection.close()
    return sorted(found, key=repr)


class Campaign:
    def __init__(self, engine, program, sources, plugin, folder):
        self.engine, self.program, self.plugin = engine, [program, "--plugin", plugin], plugin
        self.folder = folder
        self.file = folder / "engines.cfg"
        scenarios = ", ".join(f"{sources}/experiments/scenarios/{name}.yaml" for name in ("gap_small", "hppm_case1"))
        self.file.write_text(
            f"[problem]\nname = engines\nscenario = {scenarios}\n[benchmark]\nrun_count = 12\nwarm_up = 0\n"
            "time_limit = 20\njobs = 1\noutput = results\n[planner]\nrrtconnect =\nkpiece1 =\nbiest =\n"
        )

    def call(self, *words):
        done = subprocess.run([*self.program, *map(str, words)], capture_output=True, text=True)
        print("$ narrows", *words, "->", done.returncode, "\n" + done.stdout + done.stderr, flush=True)
        return done

    def submit(self):
        extra = ["--minutes", 1] if self.engine == "slurm" else ["--jobs", 2]
        return self.call("submit", self.file, "--engine", self.engine, "--shards", SHARDS, *extra)

    def check(self):
        local = self.folder / "local.db"
        assert self.call("bench", self.file, "--db", local).returncode == 0
        if self.engine == "slurm":
            self.check_slurm()
        else:
            assert self.submit().returncode == 0
        merged = self.folder / "results" / "engines.db"
        assert len(rows(local)) == 72
        assert rows(merged) == rows(local), "not the rows of the local run"
        assert self.call("doctor", merged).returncode == 0
        assert "already merged" in self.call("status", self.file).stdout
        refused = self.call("submit", self.file, "--engine", self.engine, "--shards", 5)
        assert refused.returncode == 2 and "was begun with 12 shards, not 5" in refused.stderr

    def check_slurm(self):
        faults = self.folder / "faults"
        faults.mkdir()
        (faults / "segfault-3").touch()
        (faults / "hang-5").touch()
        os.environ["NARROWS_TEST_FAULTS"] = str(faults)
        assert self.submit().returncode == 0
        self.wait()
        assert not list(faults.iterdir()), "the faults have not happened"
        status = self.call("status", self.file)
        unfinished = [line.split(":")[0] for line in status.stdout.splitlines() if line.startswith("shard ")]
        assert status.returncode == 1 and unfinished == ["shard 3", "shard 5"], unfinished
        again = self.submit()
        assert "submitted 2 shards" in again.stdout, again.stdout
        self.wait()
        assert "merged into" in (self.folder / "results" / "engines.shards" / "merge.out").read_text()

    @staticmethod
    def wait(patience=300):
        """Until Slurm has nothing left to do."""
        end = time.monotonic() + patience
        while subprocess.run(["squeue", "--noheader"], capture_output=True, text=True, check=True).stdout.strip():
            assert time.monotonic() < end, "Slurm does not come to an end"
            time.sleep(0.5)


def main(engine, program, sources, plugin, folder):
    os.environ["PATH"] = PATH
    missing = [name for name in PROGRAMS[engine] if shutil.which(name) is None]
    if missing:
        print("SKIPPED: there is no", ", ".join(missing))
        sys.exit(77)
    folder = pathlib.Path(folder).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    campaign = Campaign(engine, program, sources, plugin, folder)
    if engine != "slurm":
        campaign.check()
        return
    # Paths of sockets are short.
    slurm = pathlib.Path(subprocess.run(["mktemp", "-d"], capture_output=True, text=True, check=True).stdout.strip())
    script = pathlib.Path(__file__).with_name("one-machine-slurm")
    subprocess.run([script, "start", slurm], check=True)
    os.environ["SLURM_CONF"] = str(slurm / "slurm.conf")
    try:
        campaign.check()
    finally:
        subprocess.run([script, "stop", slurm], check=True)
        shutil.rmtree(slurm, ignore_errors=True)


main(*sys.argv[1:])
