#!/usr/bin/python3
"""Every engine of `blocks sweep` ends with the same files: engines_test.py BLOCKS [CASE] [SEED].

Without CASE, all cases run. SEED decides the moments of the faults. Exit code 77 means that a program
is missing; the reason is printed."""

import csv
import io
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from cluster import SKIPPED, Processes, SlurmCluster, SshServer, Unavailable, kill, wait_until

DECK = """\
START, 40, 4
A LAYER OF RANDOM BLOCKS FALLS ON A FLOOR
XLIMITS, -2, 12
YLIMITS, -2, 12
BOXES, 14, 14, 0.25
STIFF, 1.E8, 1.E8
FRACTION, 0.05
MATERIAL, 1, 1.E9, 4.E8, 2500
SEED, 3
RIGID
END
CREATE, 4, 1, 1
0, 0, 10, 10
-1, 0, 0, -1
LAYER, -8, 1, 0,1, 0,2, 10,2, 10,1, RANDOM
LAYER, -8, 1, 0,3, 0,4, 10,4, 10,3, RANDOM
GRAVITY, 0, -9.81
FRICTN, 0.5
DAMPING, 0.2
OUTPUT, 100
PLOTS, 100
MOTION, {time}
STOP
"""
SHORT, LONG = 0.5, 50  # [T] a run takes some ms, some tenths of a second
JOBS = 2
WAIT = 300  # [s] after which a call counts as stuck


class Sweep:
    """A sweep in a folder, and the command that goes on with it."""

    def __init__(self, blocks, deck, folder, *words, env=None):
        self.folder = Path(folder)
        self.command = [blocks, "sweep", deck, "-o", self.folder, *words]
        self.env = env

    def start(self):
        """Starts the command. What it prints goes to a file, which processes that outlive it may keep open."""
        with Path(f"{self.folder}.log").open("wb") as log:
            return subprocess.Popen([*map(str, self.command)], env=self.env, stdin=subprocess.DEVNULL,
                                    stdout=log, stderr=log)

    def call(self):
        """Runs the command and returns its exit code and what it printed."""
        code = self.start().wait(WAIT)
        return code, Path(f"{self.folder}.log").read_text()

    def complete(self, wait=lambda: None):
        """Gives the same command until all runs have an outcome; a run may still be at work elsewhere."""
        end = time.monotonic() + WAIT
        while time.monotonic() < end:
            code, text = self.call()
            wait()
            if not self.open_runs():
                return
            time.sleep(0.25)
        raise AssertionError(f"runs {self.open_runs()} are still open; the last call, code {code}, printed:\n{text}")

    def runs(self):
        return [run["id"] for run in json.loads((self.folder / "sweep.json").read_text())["runs"]]

    def place(self, run):
        return self.folder / "runs" / f"{run // 1000:03}" / f"{run:06}"

    def outcome(self, run):
        path = self.place(run) / "outcome.json"
        return json.loads(path.read_text()) if path.exists() else None

    def open_runs(self):
        return [run for run in self.runs() if not self.outcome(run)] if self.has_plan() else ["all"]

    def allow_more_time(self, wait=lambda: None):
        """Goes on with all runs but the first that reached the limit of time, which a busy machine may cause."""
        slow = [run for run in self.runs()[1:] if self.outcome(run)["code"] == 75]
        if slow:
            self.command[self.command.index("--time-limit") + 1] = str(WAIT)
            self.command += ["--retry", "--runs", f"{slow[0]}-{slow[-1]}"]
            code, text = self.call()
            wait()
            expect(code != 2, f"the runs do not go on: {text}")

    def has_plan(self):
        return (self.folder / "sweep.json").exists()

    def summary(self, run):
        paths = list(self.place(run).glob("*.summary.json"))
        return json.loads(paths[0].read_text()) if paths else {}

    def results(self):
        """Returns what must be the same for each engine: outcome.json and the hash of the last state.

        Runs that were ended by their limit of time are left out: their last state depends on the machine."""
        return {run: ((self.place(run) / "outcome.json").read_text(), self.summary(run)["state_hash"])
                for run in self.runs() if self.outcome(run) and self.outcome(run)["code"] != 75}

    def starts(self, run):
        """Returns how many times the run was begun or resumed."""
        log = self.place(run) / "log.txt"
        return len(re.findall(r"^blocks sweep: run \d", log.read_text(), re.M)) if log.exists() else 0


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def expect_same(there, wanted, what):
    different = {run: (there.get(run), wanted[run]) for run in wanted if there.get(run) != wanted[run]}
    expect(not different, f"{what}: these runs differ from the undisturbed sweep: {different}")
    expect(len(there) == len(wanted), f"{what}: {len(there)} instead of {len(wanted)} runs")


class Case:
    """The folder of a test, its decks and its undisturbed sweeps."""

    def __init__(self, blocks, folder, seed):
        self.blocks = blocks
        self.folder = Path(folder)
        self.random = random.Random(seed)
        self.sweep_time = 0.0  # [s] of the undisturbed sweep

    def deck(self, length):
        path = self.folder / f"fall{length}.deck"
        path.write_text(DECK.format(time=length))
        return path

    def time_of_run(self, deck):
        begin = time.monotonic()
        subprocess.run([self.blocks, "run", deck, "-q", "-o", self.folder / "one"], check=True, capture_output=True)
        return time.monotonic() - begin

    def faulty_words(self):
        """Returns the words of a sweep in which the first run never ends and the last is unsound.

        They end with the limit of time, which other runs may reach on a busy machine."""
        deck = self.deck(LONG)
        runs = 14
        # [s] far from what the other runs need, even if the machine stands still for some seconds
        limit = max(15, round(12 * self.time_of_run(deck)))
        table = io.StringIO()
        rows = csv.writer(table)
        rows.writerow(["seed", "GRAVITY.gravy", "MOTION.dt"])
        rows.writerow([1, -9.81, 1e7])
        rows.writerows([seed, -9.81, LONG] for seed in range(2, runs))
        rows.writerow([runs, -1e8, LONG])
        path = self.folder / "parameters.csv"
        path.write_text(table.getvalue())
        return deck, ["--table", path, "--checkpoint-every", "0.1"], ["--time-limit", str(limit)]

    def sweep(self, name, deck, *words, env=None):
        return Sweep(self.blocks, deck, self.folder / name, "-J", str(JOBS), *words, env=env)

    def undisturbed(self, deck, *words):
        sweep = self.sweep("undisturbed", deck, *words)
        begin = time.monotonic()
        sweep.call()
        self.sweep_time = time.monotonic() - begin
        return sweep

    def processes(self):
        return Processes(self.folder / "processes", "parallel")

    def ssh(self):
        return SshServer(self.folder / "ssh", "parallel")

    def slurm(self):
        return SlurmCluster(self.folder / "slurm")

    def logins(self, ssh):
        """Returns the file of the machines of GNU parallel."""
        path = self.folder / "logins"
        path.write_text(f"{JOBS}/{ssh.host}\n")
        return path

    def wait_some_time(self, parts):
        """Waits for a random part of the time of a sweep, so that it is at work several times of `parts`."""
        time.sleep(self.random.uniform(0.2, 1.0) * self.sweep_time / parts)


def expect_failed_runs(sweep):
    """The unsound run and the endless one have their code and message; all others are done."""
    endless, *rest, unsound = [sweep.outcome(run) for run in sweep.runs()]
    failed = [outcome for outcome in rest if outcome["code"] != 0]
    expect(not failed, f"these runs are not done: {failed}")
    expect(unsound["code"] == 4 and "moved a corner" in unsound["message"], f"not unsound: {unsound}")
    expect(endless["code"] == 75 and "stopped after" in endless["message"], f"not stopped by its limit: {endless}")


def tables(case, sweep):
    """Returns the tables of the report as CSV, as JSON, and the table of runs."""
    paths = [case.folder / name for name in ("table.csv", "table.json", "runs.csv")]
    done = subprocess.run([case.blocks, "report", sweep.folder, "-o", f"{paths[0]},{paths[1]}", "--run-table", paths[2]],
                          check=False, capture_output=True, text=True)
    expect(done.returncode == 0, f"blocks report ended with {done.returncode}: {done.stderr}")
    return [path.read_text() for path in paths]


def expect_failed_rows(case, sweep, undisturbed):
    """Failed runs are rows of the table of runs, and all rows but the first are those of the undisturbed sweep."""
    endless, *rest = tables(case, sweep)[2].splitlines()[1:]
    expect("75" in endless.split(",") and "stopped after" in endless, f"the endless run has the row {endless}")
    expect("4" in rest[-1].split(",") and "moved a corner" in rest[-1], f"the unsound run has the row {rest[-1]}")
    wanted = tables(case, undisturbed)[2].splitlines()[2:]
    expect(rest == wanted, f"the rows differ: {rest} instead of {wanted}")


def same(case, place, *words):
    """64 short runs: the same states, outcomes and tables as by the engine local."""
    deck = case.deck(SHORT)
    plan = ["--seeds", "1-32", "--set", "FRICTN.fric=.3,.5"]
    local = case.undisturbed(deck, *plan)
    wanted = local.results()
    expect(len({state for _, state in wanted.values()}) > 32, "the runs do not differ")
    with place as processes:
        sweep = case.sweep("other", deck, *plan, *words, env=processes.env)
        code, text = sweep.call()
        expect(code == 0, f"exit code {code}: {text}")
        if isinstance(processes, SlurmCluster):
            processes.wait_idle()
        expect_same(sweep.results(), wanted, "another engine")
        expect({sweep.starts(run) for run in sweep.runs()} == {1}, "a run was run twice")
        expect(tables(case, sweep) == tables(case, local), "the tables differ")
    return sweep


def same_parallel(case):
    sweep = same(case, case.processes(), "--engine", "parallel", "--pack", "8")
    wanted = sweep.results()
    # A killed GNU parallel leaves its present job out, and perhaps a line that it refuses to read afterwards.
    joblog = sweep.folder / "parallel/joblog"
    lines = [line for line in joblog.read_text().splitlines(keepends=True) if not line.startswith("1\t")]
    joblog.write_text("".join(lines) + "\tlocalhost\t1795612463.080\t")
    (sweep.place(5) / "outcome.json").unlink()
    code, text = sweep.call()
    expect(code == 0 and sweep.results() == wanted, f"with a damaged job log: exit code {code}: {text}")


def same_ssh(case):
    ssh = case.ssh()
    sweep = same(case, ssh, "--engine", "parallel", "--pack", "16", "--sshloginfile", case.logins(ssh))
    hosts = {line.split("\t")[1] for line in (sweep.folder / "parallel/joblog").read_text().splitlines()[1:]}
    expect(hosts == {ssh.host}, f"the jobs ran on {hosts}")


def same_slurm(case):
    same(case, case.slurm(), "--engine", "slurm", "--pack", "8")


def same_with_any_name(case, place, *words):
    """The paths have every printable character, and what GNU parallel, Slurm and shells would replace."""
    printable = "".join(map(chr, range(0x20, 0x7f))).replace("/", "")
    with place as processes:
        for name in (printable, '{= system "id >P"; =}{}{#}{%}$(id >P)', "{}", "%A_%a\\%j", "-x\ny\u00e9"):
            folder = case.folder / name
            folder.mkdir()
            deck = folder / f"{name}.deck"
            deck.write_text(DECK.format(time=SHORT))
            program = shutil.copy(case.blocks, folder / name)
            sweep = Sweep(program, deck, folder / f"{name} sweep", "--seeds", "1-3", *words, env=processes.env)
            code, text = sweep.call()
            expect(code == 0, f"{name}: exit code {code}: {text}")
            if isinstance(processes, SlurmCluster):
                processes.wait_idle()
                expect(len(list((sweep.folder / "slurm").glob("*_*.log"))) == 3, f"{name}: a log is missing")
            outcomes = [sweep.outcome(run) for run in sweep.runs()]
            expect([outcome and outcome["code"] for outcome in outcomes] == [0, 0, 0], f"{name}: {outcomes}")
    expect(not list(case.folder.rglob("P")), "a program was run")


def names_parallel(case):
    same_with_any_name(case, case.processes(), "--engine", "parallel")


def names_ssh(case):
    ssh = case.ssh()
    same_with_any_name(case, ssh, "--engine", "parallel", "--sshloginfile", case.logins(ssh))


def names_slurm(case):
    same_with_any_name(case, case.slurm(), "--engine", "slurm")


def jobs_of(processes):
    """Returns the processes that are not daemons."""
    return processes.all() - set(processes.roots())


def kill_at_random(case, processes, sweep, rounds):
    """Goes on with a sweep several times. Kills the command, one of its children or all of them."""
    for _ in range(rounds):
        command = sweep.start()
        case.wait_some_time(rounds)
        print(f"kill with {len(sweep.open_runs())} open runs", flush=True)
        for _ in range(case.random.randrange(1, 3)):
            children = sorted(jobs_of(processes) - {command.pid})
            if children and case.random.random() < 0.6:
                kill(case.random.choice(children))
                case.wait_some_time(4 * rounds)
        kill(command.pid)
        command.wait(WAIT)


def killed(case, engine, place, *words):
    """The command and its children are killed at random moments, then it is given again."""
    deck, plan, limit = case.faulty_words()
    undisturbed = case.undisturbed(deck, *plan, "--runs", "2-14")
    with place as processes:
        sweep = case.sweep("killed", deck, *plan, *limit, "--engine", engine, *words, env=processes.env)
        kill_at_random(case, processes, sweep, rounds=5)
        sweep.complete()
        sweep.allow_more_time()
        expect_failed_runs(sweep)
        expect_same(sweep.results(), undisturbed.results(), f"{engine} after random kills")
        expect_failed_rows(case, sweep, undisturbed)


def killed_local(case):
    killed(case, "local", Processes(case.folder / "processes"))


def killed_parallel(case):
    ssh = case.ssh()
    killed(case, "parallel", ssh, "--pack", "2", "--sshloginfile", case.logins(ssh))


def killed_slurm(case):
    """slurmd, slurmctld, the node and the runs are killed at random moments."""
    deck, words, limit = case.faulty_words()
    undisturbed = case.undisturbed(deck, *words, "--runs", "2-14")
    with case.slurm() as slurm:
        sweep = case.sweep("killed", deck, *words, *limit, "--engine", "slurm", "--pack", "2", env=slurm.env)

        def kill_run():
            runs = [process for process in sorted(jobs_of(slurm)) if is_blocks(process)]
            if runs:
                kill(case.random.choice(runs))

        def kill_node():
            slurm.kill_node()
            case.wait_some_time(8)
            slurm.start_node()

        def kill_controller():
            slurm.kill_controller()
            case.wait_some_time(8)
            slurm.start_controller()

        def crash():
            slurm.crash_node()
            slurm.start_node()

        def wait(condition):
            """Waits; meanwhile the administrator mends the cluster."""
            wait_until(lambda: slurm.recover() or condition(slurm.jobs()), WAIT, "a job")

        def wait_for_end():
            wait(lambda jobs: not jobs)

        faults = [kill_run, kill_node, crash, kill_controller]
        case.random.shuffle(faults)
        for fault in faults:
            sweep.call()
            wait(lambda jobs: not jobs or any(job.endswith("RUNNING") for job in jobs))
            case.wait_some_time(8)
            print(f"{fault.__name__} with {len(sweep.open_runs())} open runs, jobs {slurm.jobs()}", flush=True)
            fault()

        wait_for_end()
        sweep.complete(wait_for_end)
        sweep.allow_more_time(wait_for_end)
        expect_failed_runs(sweep)
        expect_same(sweep.results(), undisturbed.results(), "slurm after random kills")
        expect_failed_rows(case, sweep, undisturbed)


def is_blocks(process):
    try:
        return os.path.basename(os.readlink(f"/proc/{process}/exe")) == "blocks"
    except OSError:
        return False


def interrupted(case, engine):
    """Ctrl-C at random moments, then the same command: nothing is lost, nothing runs twice."""
    deck = case.deck(LONG)
    words = ["--seeds", "1-12"]
    wanted = case.undisturbed(deck, *words).results()
    with case.processes() as processes:
        sweep = case.sweep("interrupted", deck, *words, "--engine", engine, env=processes.env)
        interrupts, steps = 0, {}
        for _ in range(5):
            command = sweep.start()
            case.wait_some_time(5)
            command.send_signal(signal.SIGINT)
            code = command.wait(WAIT)
            print(f"Ctrl-C with {len(sweep.open_runs())} open runs", flush=True)
            interrupts += 1
            expect(code in (0, 130, -signal.SIGINT), f"{engine}: Ctrl-C ended it with exit code {code}")
            wait_until(lambda: not processes.all(), WAIT, f"{engine}: the end of the runs")
            for run in sweep.runs() if sweep.has_plan() else []:
                now = sweep.summary(run).get("steps", 0)
                before = steps.get(run, 0)
                expect(now >= before, f"{engine}: run {run} lost steps: {before} to {now}")
                steps[run] = now
        sweep.complete()
        expect_same(sweep.results(), wanted, f"{engine} after Ctrl-C")
        starts = sum(sweep.starts(run) for run in sweep.runs())
        expect(starts <= len(wanted) + JOBS * interrupts, f"{engine}: {starts} starts of {len(wanted)} runs")
        finished = {run: os.stat(sweep.place(run) / "outcome.json").st_mtime_ns for run in sweep.runs()}
        sweep.call()
        expect(finished == {run: os.stat(sweep.place(run) / "outcome.json").st_mtime_ns for run in sweep.runs()}
               and starts == sum(sweep.starts(run) for run in sweep.runs()), f"{engine}: a finished run ran again")


def interrupted_local(case):
    interrupted(case, "local")


def interrupted_parallel(case):
    interrupted(case, "parallel")


def two_commands(case):
    """Two commands that go on with one sweep at once share its runs."""
    deck = case.deck(LONG)
    words = ["--seeds", "1-12"]
    wanted = case.undisturbed(deck, *words).results()
    sweep = case.sweep("shared", deck, *words)
    commands = [sweep.start(), sweep.start()]
    for command in commands:
        command.wait(WAIT)
    sweep.complete()
    expect_same(sweep.results(), wanted, "after two commands at once")
    expect({sweep.starts(run) for run in sweep.runs()} == {1}, "a run was run twice")


def full_disk(case):
    """The disk is full in the middle of a sweep. After there is room again, it goes on."""
    deck = case.deck(LONG)
    words = ["--seeds", "1-12"]
    wanted = case.undisturbed(deck, *words).results()
    mount = ["unshare", "--mount", "--propagation", "private"]
    there = case.folder / "disk"
    there.mkdir()
    script = f"""
        mount -t tmpfs -o size=2m tmpfs '{there}' || exit 99
        "$@"; echo $? >'{case.folder}/code'
        mount -o remount,size=200m '{there}'
        "$@" && cp -r '{there}/sweep' '{case.folder}/room'
    """
    sweep = case.sweep("disk/sweep", deck, *words)
    done = subprocess.run([*mount, "sh", "-c", script, "sh", *map(str, sweep.command)], check=False,
                          capture_output=True, text=True) if shutil.which("unshare") else None
    if done and done.returncode == 0:
        code, text = int((case.folder / "code").read_text()), done.stderr
        sweep.folder = case.folder / "room"
    elif done and (case.folder / "code").exists():
        raise AssertionError(f"the sweep did not go on: {done.stdout}{done.stderr}")
    else:
        # There is no right to mount a small disk: a limit of the size of a file is next to it.
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))

        first = subprocess.run([*map(str, sweep.command)], check=False, capture_output=True, text=True,
                               preexec_fn=small_files)
        code, text = first.returncode, first.stderr
        sweep.complete()
    expect(code == 5 and "could not write its files" in text and "hint:" in text,
           f"on a full disk it ended with {code}: {text}")
    expect_same(sweep.results(), wanted, "after the full disk")


def requeue(case):
    """At the end of their time, tasks of Slurm wait in the queue again and the runs go on."""
    deck = case.deck(2 * LONG)
    words = ["--seeds", "1-4"]
    undisturbed = case.undisturbed(deck, *words)
    with case.slurm() as slurm:
        sweep = case.sweep("requeued", deck, *words, "--engine", "slurm", "--pack", "2", env=slurm.env)
        code, text = sweep.call()
        expect(code == 0, f"slurm: exit code {code}: {text}")
        wait_until(lambda: sweep.starts(1) and sweep.starts(3), WAIT, "the start of the runs")
        job = re.search(r"\d+", text).group()
        # Before the end of the time, the batch script alone gets TERM, as here.
        slurm.call("scancel", "--signal=TERM", "--batch", job)
        wait_until(lambda: len([line for line in slurm.jobs() if line.endswith("PENDING")]) == 2, WAIT, "the requeue")
        steps = {run: sweep.summary(run).get("steps", 0) for run in (1, 3)}
        expect(all(steps.values()), f"no checkpoint was written: {steps}")
        expect(sweep.outcome(1) is None, "a run that was stopped has an outcome")
        slurm.wait_idle()
        expect(not sweep.open_runs(), f"runs {sweep.open_runs()} did not go on")
        expect_same(sweep.results(), undisturbed.results(), "after the requeue")
        expect([sweep.starts(run) for run in sweep.runs()] == [2, 1, 2, 1], "a run was not resumed once")


def cancelled(case):
    """A task that is cancelled does not come back by itself; the same command goes on with its runs."""
    deck = case.deck(2 * LONG)
    words = ["--seeds", "1-2"]
    undisturbed = case.undisturbed(deck, *words)
    with case.slurm() as slurm:
        sweep = case.sweep("cancelled", deck, *words, "--engine", "slurm", env=slurm.env)
        code, text = sweep.call()
        expect(code == 0, f"slurm: exit code {code}: {text}")
        wait_until(lambda: sweep.starts(1) and sweep.starts(2), WAIT, "the start of the runs")
        slurm.call("scancel", re.search(r"\d+", text).group())
        slurm.wait_idle()
        time.sleep(1)  # a requeue would be seen by now
        expect(not slurm.jobs() and sweep.open_runs() == [1, 2], "the job came back or had ended before")
        sweep.complete(slurm.wait_idle)
        expect_same(sweep.results(), undisturbed.results(), "after the cancellation")


CASES = {case.__name__: case for case in (
    same_parallel, same_ssh, same_slurm, names_parallel, names_ssh, names_slurm, killed_local, killed_parallel,
    killed_slurm, interrupted_local, interrupted_parallel, two_commands, full_disk, requeue, cancelled)}


def main():
    blocks, name, seed = (sys.argv[1:] + ["", "1"][len(sys.argv) - 2:])[:3]
    skipped = False
    for name in [name] if name else CASES:
        begin = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            os.chmod(folder, 0o755)
            try:
                CASES[name](Case(os.path.abspath(blocks), folder, seed))
                print(f"{name}: {time.monotonic() - begin:.1f} s", flush=True)
            except Unavailable as reason:
                print(f"{name}: skipped: {reason}", flush=True)
                skipped = True
    sys.exit(SKIPPED if skipped else 0)


main()
