#!/usr/bin/env python3
"""Times whole runs of ravnoves-cli, taken in turns: medians of processor and wall time, and the share of
`--version` in the same turns. Then the most memory that a batch and a study take, small and large.

command_line.py PROGRAM [RUNS [CASES]]    60 runs each; a batch of 100 000 cases, ten times the samples
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
ONLY = ["--only", "/metrics/M_ups/range_Nm,/optimum/range"]


def run(command, read=None):
    """Processor and wall time, ms."""
    begin = time.perf_counter()
    silent = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
    if read:
        silent.append((os.POSIX_SPAWN_OPEN, 0, read, os.O_RDONLY, 0))
    child = os.posix_spawn(command[0], command, os.environ, file_actions=silent)
    _, status, used = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{command}: status {status}")
    return 1e3 * (used.ru_utime + used.ru_stime), 1e3 * (time.perf_counter() - begin)


def peak(command, read=None):
    """kB, of a child whose parent is small: a fork begins with its parent's peak."""
    script = 'exec "$@" >/dev/null' + (f" <{read}" if read else "")
    measured = subprocess.run(
        [sys.executable, "-S", "-c", "import os, sys\n"
         "child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ)\n"
         "print(os.wait4(child, 0)[2].ru_maxrss)", "/bin/sh", "-c", script, "sh", *command],
        check=True, capture_output=True, text=True)
    return int(measured.stdout)


def main():
    program = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    cases = int(sys.argv[3]) if len(sys.argv) > 3 else 100_000
    commands = [[program, "--version"],
                [program, "solve", str(EXAMPLES / "tmz-650d.case.json"), *ONLY]]
    for name in ("v8-4.25-repair", "vr5-volkswagen", "zotov-energy", "tmz-650d"):
        commands.append([program, "solve", str(EXAMPLES / f"{name}.case.json")])
    taken = [[run(command) for command in commands] for _ in range(runs)]
    for k, command in enumerate(commands):
        processor, wall = (statistics.median(turn[k][i] for turn in taken) for i in (0, 1))
        share, wall_share = (statistics.median(turn[k][i] / turn[0][i] for turn in taken)
                             for i in (0, 1))
        words = " ".join(command[1:]).replace(f"{EXAMPLES}/", "")
        print(f"command {words:78} processor {processor:6.2f} ms {share:5.2f}  "
              f"wall {wall:6.2f} ms {wall_share:5.2f}")

    case = json.loads((EXAMPLES / "tmz-650d.case.json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        for count in (cases // 100, cases):
            lines = Path(folder, "lines")
            with lines.open("w") as file:
                file.writelines([json.dumps(case) + "\n"] * count)
            print(f"memory  batch of {count} cases: "
                  f"{peak([program, 'solve', '--batch', *ONLY], lines)} kB")
        case["study"] = {"vary": {"/crank_radius_mm": {"plus_minus": 0.02}},
                         "watch": {"/metrics/M_ups/range_Nm": {}}}
        for count in (cases // 10, 10 * cases):
            case["study"]["samples"] = count
            path = Path(folder, "study.case.json")
            path.write_text(json.dumps(case))
            print(f"memory  study of {count} samples: {peak([program, 'study', str(path)])} kB")


if __name__ == "__main__":
    main()
