"""A study as an array job, on a Slurm of one node with two slots that the test starts for itself."""
import getpass
import os
import shutil
import signal
import socket
import subprocess
import time

import pytest
from swarf.study import command
from test_study import A, DECK, write_program

NEEDED = ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scancel")
CONFIG = """ClusterName=test
SlurmctldHost={host}
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MailProg=/bin/true
ReturnToService=2
InactiveLimit=0
KillWait=2
NodeName={host} CPUs=2 State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as one:
        one.bind(("", 0))
        return one.getsockname()[1]


def wait_for(what, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if what():
            return True
        time.sleep(0.5)
    return False


def said(*words):
    return subprocess.run(words, capture_output=True, text=True).stdout.strip()


@pytest.fixture
def cluster(tmp_path, monkeypatch):
    path = os.environ["PATH"] + ":/usr/sbin:/sbin"
    monkeypatch.setenv("PATH", path)
    missing = [name for name in NEEDED if not shutil.which(name, path=path)]
    if missing:
        pytest.skip(f"no {', '.join(missing)}: Debian has them in slurmctld, slurmd, slurm-client and munge")
    folder = tmp_path / "slurm"
    (folder / "state").mkdir(parents=True)
    (folder / "spool").mkdir()
    folder.chmod(0o711)
    key = folder / "munge.key"
    key.write_bytes(os.urandom(1024))
    key.chmod(0o400)
    (folder / "slurm.conf").write_text(CONFIG.format(
        host=socket.gethostname().partition(".")[0], user=getpass.getuser(), folder=folder, controller_port=free_port(),
        node_port=free_port()))
    monkeypatch.setenv("SLURM_CONF", str(folder / "slurm.conf"))
    monkeypatch.delenv("SBATCH_PARTITION", raising=False)
    started = [subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for words in (
        ["munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket",
         f"--pid-file={folder}/munge.pid", f"--log-file={folder}/munge.log", f"--seed-file={folder}/munge.seed"],)]
    try:
        wait_for((folder / "munge.socket").exists, 20)
        for program in ("slurmctld", "slurmd"):
            log = open(folder / f"{program}.out", "w")
            started.append(subprocess.Popen([program, "-D"], stdout=log, stderr=subprocess.STDOUT))
        if not wait_for(lambda: "idle" in said("sinfo", "-h", "-o", "%T")):
            logs = "\n".join(one.read_text()[-1500:] for one in folder.glob("*.log")) + said("sinfo", "-R")
            pytest.skip(f"Slurm is installed but does not start here: {logs}")
        yield folder
    finally:
        subprocess.run(["scancel", "--user", getpass.getuser()], capture_output=True)
        wait_for(lambda: not said("squeue", "-h"), 20)
        for one in reversed(started):
            one.send_signal(signal.SIGTERM)
        for one in reversed(started):
            try:
                one.wait(20)
            except subprocess.TimeoutExpired:
                one.kill()


def test_study_on_slurm_survives_killed_tasks(cluster, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "deck.toml").write_text(DECK)
    gate = tmp_path / "gate"  # runs wait for it
    program = write_program(tmp_path / "swarf", f"while [ ! -e {gate} ]; do sleep 0.2; done\n")
    monkeypatch.setenv("SWARF_PROGRAM", str(program))
    monkeypatch.setenv("KILL_AT", "run_0001")  # the program dies in its first call
    plan = tmp_path / "plan.toml"
    plan.write_text('deck = "deck.toml"\ndesign = "grid"\n' + A.replace("levels = 3", "levels = 5"))
    assert command.main([str(plan), "--submit", "slurm", "--jobs", "2"]) == 0
    assert "submitted: array job" in capsys.readouterr().out
    folder = tmp_path / "results" / "plan"

    def running():
        return said("squeue", "-h", "-r", "-t", "R", "-o", "%K").split()
    assert wait_for(lambda: len(running()) == 2)  # two slots, and no more
    array = said("squeue", "-h", "-r", "-t", "R", "-o", "%F").split()[0]
    victim = running()[0]
    subprocess.run(["scancel", f"{array}_{victim}"], check=True)  # one whole task is killed
    assert wait_for(lambda: victim not in running())
    gate.touch()
    assert wait_for(lambda: not said("squeue", "-h"), 120), said("squeue")
    done = {path.parent.name for path in folder.glob("runs/*/summary.json")}
    assert done == {f"run_{k:04d}" for k in range(5)} - {f"run_{int(victim):04d}"}
    calls = (folder / "runs" / "run_0001" / "calls")
    if victim != "1":  # its program died, its task did not
        assert len(calls.read_text().splitlines()) == 2
    assert len((folder / "study.csv").read_text().splitlines()) == 1 + 4  # the job behind has put together what is there

    assert command.main([str(plan), "--submit", "slurm"]) == 0  # takes up what is missing
    assert f"--array={victim}%1" in (folder / "study.sbatch").read_text()
    assert wait_for(lambda: not said("squeue", "-h"), 120)
    assert len((folder / "study.csv").read_text().splitlines()) == 1 + 5
    assert command.main([str(plan), "--submit", "slurm"]) == 0
    assert "nothing to submit" in capsys.readouterr().out
