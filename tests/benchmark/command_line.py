#!/usr/bin/env python3
"""Times whole runs of ravnoves-cli, taken in turns: the median of the processor time, beside that of
`--version`, and its share in the same turns. Then the most memory that a batch and a study take,
beside those of a hundredth of the size. Lines `name | value | rival | share`, as table.py has them.

command_line.py PROGRAM [RUNS [CASES]]    60 runs each; a batch of 100 000 cases, a study of a
                                          hundred times as many samples
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
ONLY = ["--only", "/metrics/M_ups/range_Nm,/optimum/range"]


def run(command):
    """Processor time, ms."""
    silent = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
    child = os.posix_spawn(command[0], command, os.environ, file_actions=silent)
    _, status, used = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{command}: status {status}")
    return 1e3 * (used.ru_utime + used.ru_stime)


def peak(command, read=None):
    """kB, of a child whose parent is small: a fork begins with its parent's peak."""
    script = 'exec "$@" >/dev/null' + (f" <{read}" if read else "")
    measured = subprocess.run(
        [sys.executable, "-S", "-c", "import os, sys\n"
         "child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ)\n"
         "print(os.wait4(child, 0)[2].ru_maxrss)", "/bin/sh", "-c", script, "sh", *command],
        check=True, capture_output=True, text=True)
    return int(measured.stdout)


def print_peaks(name, peaks):
    small, large = peaks
    print(f"memory at most, {name} (rival: a hundredth of them) | {large / 1024:.1f} MB | "
          f"{small / 1024:.1f} MB | {large / small:.2f}")


def main():
    program = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    cases = int(sys.argv[3]) if len(sys.argv) > 3 else 100_000
    commands = [[program, "--version"],
                [program, "solve", str(EXAMPLES / "tmz-650d.case.json"), *ONLY]]
    for name in ("v8-4.25-repair", "vr5-volkswagen", "zotov-energy", "tmz-650d"):
        commands.append([program, "solve", str(EXAMPLES / f"{name}.case.json")])
    taken = [[run(command) for command in commands] for _ in range(runs)]
    version = statistics.median(turn[0] for turn in taken)
    for k, command in enumerate(commands[1:], 1):
        words = " ".join(Path(word).name if word.endswith(".json") else word for word in command[1:])
        share = statistics.median(turn[k] / turn[0] for turn in taken)
        print(f"{words.replace(',', ', ')} (rival: --version) | "
              f"{statistics.median(turn[k] for turn in taken):.2f} ms | {version:.2f} ms | {share:.2f}")

    case = json.loads((EXAMPLES / "tmz-650d.case.json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        peaks = []
        for count in (cases // 100, cases):
            lines = Path(folder, "lines")
            with lines.open("w") as file:
                for _ in range(count):
                    file.write(json.dumps(case) + "\n")
            peaks.append(peak([program, "solve", "--batch", *ONLY], lines))
            lines.unlink()
        print_peaks(f"batch of {cases} cases", peaks)
        case["study"] = {"vary": {"/crank_radius_mm": {"plus_minus": 0.02}},
                         "watch": {"/metrics/M_ups/range_Nm": {}}}
        peaks = []
        for count in (cases, 100 * cases):
            case["study"]["samples"] = count
            path = Path(folder, "study.case.json")
            path.write_text(json.dumps(case))
            peaks.append(peak([program, "study", str(path)]))
        print_peaks(f"study of {100 * cases} samples", peaks)


if __name__ == "__main__":
    main()
