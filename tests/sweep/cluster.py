"""A Slurm cluster of one node and an SSH server for tests, each in a folder of its own.

    with Processes(folder) as processes:
        subprocess.run([...], env=processes.env)

    with SlurmCluster(folder) as slurm:
        subprocess.run(["sbatch", ...], env=slurm.env)

    with SshServer(folder) as ssh:
        subprocess.run(["parallel", "-S", ssh.host, ...], env=ssh.env)

Nothing outside the folder is changed, apart from the empty folder /run/sshd if it is missing. All
daemons and jobs end with the test, even if the test is killed. If a program is missing or does not
start, Unavailable gives the reason; a test is then skipped (exit code 77)."""

import contextlib
import getpass
import os
import random
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

SKIPPED = 77  # exit code that CTest reports as a skipped test
PORTS = (20000, 32000)
STARTS = 3  # another program may have taken a port in the meantime
START_TIME = 20  # [s] a daemon that is not ready after this time counts as unavailable
SYSTEM_PATH = "/usr/local/sbin:/usr/sbin:/sbin"  # an ordinary user's PATH lacks the daemons

SLURM_PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel", "sinfo")

MARK = "BLOCKS_TEST_CLUSTER"  # variable that every process of a cluster inherits

CONFIGURATION = """\
ClusterName=blocks
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
CredType=cred/munge
# A requeued job waits until its credential has expired: 5 s is the least, 120 s the default.
AuthInfo=socket={folder}/munge/socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
# There may be no cgroups, no systemd and no D-Bus.
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
# More jobs run at once than the machine has cores, and they start without delay.
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0,sched_min_interval=1
JobRequeue=1
ReturnToService=2
# Failures are noticed within seconds.
SlurmctldTimeout=5
SlurmdTimeout=5
InactiveLimit=0
KillWait=2
MinJobAge=600
MessageTimeout=4
BatchStartTimeout=1
TCPTimeout=2
NodeName=node NodeHostname={host} NodeAddr=127.0.0.1 Port={node_port} CPUs={cpus} State=UNKNOWN
PartitionName=tests Nodes=node Default=YES MaxTime=INFINITE State=UP
"""


class Unavailable(Exception):
    """Says why a cluster cannot be started on this machine."""


class DaemonEnded(Unavailable):
    """Says why a daemon ended at its start; with another port it may work."""


def free_port():
    """Returns a free port below those that the system gives to connections."""
    while True:
        with socket.socket() as probe, contextlib.suppress(OSError):
            port = random.SystemRandom().randrange(*PORTS)
            probe.bind(("127.0.0.1", port))
            return port


def program(name):
    """Returns the path of a program, which need not be in an ordinary user's PATH."""
    path = shutil.which(name, path=f"{os.environ.get('PATH', '')}:{SYSTEM_PATH}")
    if not path:
        raise Unavailable(f"{name} is not installed")
    return path


def wait_until(condition, seconds, what):
    """Returns the first true value of condition(). Raises TimeoutError after that many seconds."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise TimeoutError(f"{what} took more than {seconds} s")
        time.sleep(0.05)


def kill(process, name=signal.SIGKILL):
    """Sends a signal to a process, which may have ended."""
    with contextlib.suppress(OSError):
        os.kill(process, name)


def environment(process):
    with contextlib.suppress(OSError):
        return Path("/proc", str(process), "environ").read_bytes().split(b"\0")
    return []


def works_in(process, folder):
    with contextlib.suppress(OSError):
        return os.readlink(f"/proc/{process}/cwd") == str(folder)
    return False


def status(process):
    """Returns the fields of /proc/ID/stat after the name: state, parent ...; none if it has ended."""
    with contextlib.suppress(OSError):
        return Path("/proc", str(process), "stat").read_bytes().rsplit(b")", 1)[1].split()
    return []


def start_of(process):
    """Returns when a process began, in ticks, or 0: an id alone may belong to another process later."""
    fields = status(process)
    return int(fields[19]) if fields else 0


def parents():
    """Returns the id of the parent of each process that has not ended."""
    found = {}
    for entry in os.listdir("/proc"):
        fields = status(entry) if entry.isdigit() else []
        if fields and fields[0] != b"Z":
            found[int(entry)] = int(fields[1])
    return found


def processes_of(mark, home, roots):
    """Returns the ids of the processes of a cluster: roots, those that began with the mark, and descendants.

    slurmstepd overwrites its environment, but it stays in the folder of its slurmd, home."""
    parent = parents()
    word = f"{MARK}={mark}".encode()
    found = set(roots) & set(parent)
    found |= {process for process in parent if word in environment(process) or works_in(process, home)}
    grown = True
    while grown:
        more = {process for process in parent if parent[process] in found} - found
        grown = bool(more)
        found |= more
    return found - {os.getpid()}


def kill_all(mark, home, roots):
    """Kills the processes of a cluster until none is left: one may have started another."""
    while found := processes_of(mark, home, roots):
        for process in found:
            kill(process)
        time.sleep(0.02)


class Processes:
    """Ends all processes that were started with env, and their descendants.

    Subclasses start daemons as well. `folder` holds their files; it may be removed afterwards."""

    def __init__(self, folder, *programs):
        """Programs are further ones that the test needs."""
        self.programs = programs
        self.folder = Path(folder).resolve()
        self.home = self.folder / "home"
        self.home.mkdir(parents=True, exist_ok=True)
        self.mark = secrets.token_hex(8)
        # The test itself may run in a job of Slurm. GNU parallel would write into the home folder.
        self.env = {name: text for name, text in os.environ.items() if not name.startswith(("SLURM", "SBATCH"))}
        self.env.update({MARK: self.mark, "PARALLEL_HOME": str(self.folder)})
        self.daemons = {}
        self.watch = None

    def __enter__(self):
        for name in self.programs:
            program(name)
        # If the test is killed, the pipe closes and the guard kills what the test has started. The
        # guard is no child of the test, so that ctest does not kill it with the test.
        reading, self.watch = os.pipe()
        subprocess.run([sys.executable, __file__, self.mark, self.home], stdin=reading, check=True)
        os.close(reading)
        try:
            self.start_again_and_again()
        except BaseException:
            self.__exit__()
            raise
        return self

    def start_again_and_again(self):
        for _ in range(STARTS - 1):
            try:
                return self.start()
            except DaemonEnded as reason:
                print(f"trying again: {reason}", flush=True)
                kill_all(self.mark, self.home, self.roots())
                shutil.rmtree(self.folder)
                self.home.mkdir(parents=True)
        return self.start()

    def __exit__(self, *_):
        kill_all(self.mark, self.home, self.roots())
        for daemon in self.daemons.values():
            daemon.wait()
        os.close(self.watch)

    def start(self):
        pass

    def all(self):
        """Returns the ids of all processes that are still at work."""
        return processes_of(self.mark, self.home, self.roots())

    def roots(self):
        return [daemon.pid for daemon in self.daemons.values() if daemon.poll() is None]

    def log(self, name):
        return self.folder / f"{name}.log"

    def start_daemon(self, name, *arguments):
        """Starts a daemon, which stays in the foreground of a session of its own."""
        command = [program(name), *map(str, arguments)]
        with self.log(name).open("ab") as log:
            self.daemons[name] = subprocess.Popen(
                command, env=self.env, cwd=self.home, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                start_new_session=True)
        process = self.daemons[name].pid
        os.write(self.watch, b"%d %d\n" % (process, start_of(process)))

    def kill_daemon(self, name):
        self.daemons[name].kill()
        self.daemons[name].wait()

    def wait_for(self, name, condition):
        """Waits until a daemon works. Raises Unavailable with its log if it ends or takes too long."""

        def works():
            if self.daemons[name].poll() is not None:
                raise DaemonEnded(f"{name} does not start: {self.last_lines(name)}")
            return condition()

        try:
            return wait_until(works, START_TIME, f"the start of {name}")
        except TimeoutError as error:
            raise Unavailable(f"{error}: {self.last_lines(name)}") from error

    def last_lines(self, name):
        return " / ".join(self.log(name).read_text(errors="replace").splitlines()[-5:])


class SlurmCluster(Processes):
    """slurmctld, slurmd and munged; env is the environment for sbatch, squeue and scontrol."""

    def __init__(self, folder, cpus=4):
        super().__init__(folder, *SLURM_PROGRAMS)
        self.configuration = self.folder / "slurm.conf"
        self.cpus = cpus
        self.env.update(SLURM_CONF=str(self.configuration), PATH=f"{os.environ.get('PATH', '')}:{SYSTEM_PATH}")

    def start(self):
        for name in ("munge", "state", "spool"):
            (self.folder / name).mkdir(mode=0o755, exist_ok=True)
        key = self.folder / "munge/key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        self.configuration.write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], user=getpass.getuser(), folder=self.folder, cpus=self.cpus,
            controller_port=free_port(), node_port=free_port()))
        munge = self.folder / "munge"
        # munged trusts a key only in folders of root; --force turns this into a warning.
        self.start_daemon("munged", "--foreground", "--force", f"--socket={munge}/socket", f"--key-file={key}",
                          f"--pid-file={munge}/pid", f"--log-file={munge}/log", f"--seed-file={munge}/seed")
        self.wait_for("munged", (munge / "socket").exists)
        self.start_controller()
        self.start_node()
        self.wait_for("slurmd", lambda: self.node_state() == "idle")

    def start_controller(self):
        self.start_daemon("slurmctld", "-D", "-f", self.configuration)
        self.wait_for("slurmctld", lambda: self.call("scontrol", "ping", check=False).returncode == 0)

    def start_node(self):
        self.start_daemon("slurmd", "-D", "-N", "node", "-f", self.configuration)

    def kill_controller(self):
        self.kill_daemon("slurmctld")

    def kill_node(self):
        """Kills slurmd. Its jobs go on, as each of them has a slurmstepd of its own."""
        self.kill_daemon("slurmd")

    def recover(self):
        """Does what an administrator does after a crash: resumes the node and releases held jobs.

        A controller that is killed within 5 s of a job's start forgets the start. It then tries to
        start the job again, which slurmd refuses; the job is held and the node is drained."""
        self.call("scontrol", "update", "NodeName=node", "State=RESUME", check=False)
        held = [line.split()[0] for line in self.call(
            "squeue", "--noheader", "--array", "--format=%i %r").stdout.splitlines() if "held" in line.lower()]
        for job in held:
            self.call("scontrol", "release", job, check=False)

    def crash_node(self):
        """Kills slurmd and all jobs, as if the node had lost power, and reports it.

        Without the report it takes the controller up to 30 s to see that the jobs are gone."""
        self.kill_daemon("slurmd")
        kept = set(self.roots())
        jobs = [process for process in self.all() if process not in kept and (
            works_in(process, self.home) or any(word.startswith(b"SLURM_JOB_ID=") for word in environment(process)))]
        # All stop before the first is killed: otherwise a slurmstepd would report the end of its script.
        for name in (signal.SIGSTOP, signal.SIGKILL):
            for process in jobs:
                kill(process, name)
        self.call("scontrol", "update", "NodeName=node", "State=DOWN", "Reason=crash")

    def call(self, *command, check=True):
        """Runs a command of Slurm and returns what it printed."""
        return subprocess.run(command, env=self.env, check=check, capture_output=True, text=True, timeout=60)

    def node_state(self):
        return self.call("sinfo", "--noheader", "--nodes=node", "--format=%T", check=False).stdout.strip()

    def jobs(self):
        """Returns the lines "ID STATE" of all jobs that wait or run, one for each array task."""
        return self.call("squeue", "--noheader", "--array", "--format=%i %T").stdout.splitlines()

    def wait_idle(self, seconds=300):
        """Waits until no job waits or runs."""
        wait_until(lambda: not self.jobs(), seconds, "the end of all jobs")


class SshServer(Processes):
    """sshd on the loopback address, for the user that runs the test.

    host is a name that only the client `command` knows; GNU parallel finds this client in env."""

    host = "loopback"

    def __init__(self, folder, *programs):
        super().__init__(folder, "sshd", "ssh", "ssh-keygen", *programs)

    def start(self):
        if os.geteuid() == 0:
            Path("/run/sshd").mkdir(mode=0o755, exist_ok=True)  # Debian's sshd insists on this folder.
        for name in ("host", "client"):
            subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", self.folder / name], check=True)
        port = free_port()
        host_key = (self.folder / "host.pub").read_text()
        (self.folder / "known").write_text(f"[127.0.0.1]:{port} {host_key}")
        # A shell with this HOME reads no start-up files of the user, so no kill interrupts one.
        (self.folder / "sshd.conf").write_text(
            f"ListenAddress 127.0.0.1:{port}\nHostKey {self.folder}/host\nPidFile none\n"
            f"AuthorizedKeysFile {self.folder}/client.pub\nStrictModes no\nUsePAM no\n"
            "PasswordAuthentication no\nPermitRootLogin prohibit-password\n"
            f"MaxStartups 100\nMaxSessions 100\nSetEnv {MARK}={self.mark} HOME={self.home}\n")
        (self.folder / "ssh.conf").write_text(
            f"Host {self.host}\nHostName 127.0.0.1\nPort {port}\nUser {getpass.getuser()}\n"
            f"IdentityFile {self.folder}/client\nIdentitiesOnly yes\nBatchMode yes\n"
            f"ConnectTimeout 5\nUserKnownHostsFile {self.folder}/known\nGlobalKnownHostsFile none\nLogLevel ERROR\n")
        self.command = f"{program('ssh')} -F {self.folder}/ssh.conf"
        self.env["PARALLEL_SSH"] = self.command
        self.start_daemon("sshd", "-D", "-e", "-f", self.folder / "sshd.conf")
        self.wait_for("sshd", lambda: subprocess.run(
            ["timeout", "5", *self.command.split(), self.host, "true"], env=self.env, check=False,
            capture_output=True).returncode == 0)


if __name__ == "__main__":
    # This is the guard of a test: it waits until the pipe is closed, even by the death of the test.
    if os.fork() == 0:
        os.setsid()
        daemons = [tuple(map(int, line.split())) for line in sys.stdin]
        kill_all(sys.argv[1], sys.argv[2], [process for process, start in daemons if start_of(process) == start])
