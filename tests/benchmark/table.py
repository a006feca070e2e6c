#!/usr/bin/env python3
"""Prints the table of speeds and memory, each beside what a user would pick instead.

    tests/benchmark/table.py [BUILD] [--quick]      BUILD: build/benchmark, of the preset `benchmark`

Absolute times move by a factor of two on a shared machine; the shares, each of two times of one
run, do not. Every program of PROGRAMS prints lines `name | value | rival | share`; start and memory
are measured here, on the program itself.
"""

import os
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time

QUICK = "--quick" in sys.argv
BUILD = next((word for word in sys.argv[1:] if not word.startswith("-")), "build/benchmark")
STEPS = "60" if QUICK else "500"
RUNS = 5 if QUICK else 21

# Program of the benchmarks, its arguments, and what it finds in the environment.
PROGRAMS = [
    (["bench-ui-frames", "--table", "--steps", STEPS], {}),
    (["bench-ui-frames", "--table", "--steps", STEPS, "--size", "1920x1080"], {}),
    (["bench-ui-frames", "--table", "--steps", STEPS], {"QT_SCALE_FACTOR": "2"}),
]


def scenes_of(program):
    """As the program lists them: a name that none has makes it say all."""
    with tempfile.TemporaryDirectory() as home:
        refused = subprocess.run([program, "--screenshot", os.devnull, "--scene", "?"],
                                 env=environment(home, {}), stderr=subprocess.PIPE, text=True).stderr
    listed = re.search(r"must be one of (.*), got \?", refused).group(1).split(", ")
    return [scene for scene in listed if scene != "start"]


def environment(home, more):
    kept = {name: value for name, value in os.environ.items()
            if name not in ("QT_SCALE_FACTOR", "QT_FONT_DPI", "QT_LOGGING_RULES")}
    return {**kept, "QT_QPA_PLATFORM": "offscreen", "XDG_CONFIG_HOME": home + "/config",
            "XDG_DATA_HOME": home + "/data", "XDG_RUNTIME_DIR": home, **more}


def rows_of(program, more, home):
    path = os.path.join(BUILD, "tests/benchmark", program[0])
    if not os.path.exists(path):
        sys.exit(f"{path}: not there; build the preset `benchmark` first")
    printed = subprocess.run([path, *program[1:]], env=environment(home, more), text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True).stdout
    rows = [[part.strip() for part in line.split("|")] for line in printed.splitlines()]
    return [row for row in rows if len(row) == 4]


def painted(command, stays=0.0):
    """Runs a program until its first picture is painted, and `stays` seconds on.

    Qt says on its error channel when it brings a picture to the screen. Each run has a home of its
    own: what is killed leaves its locks behind.
    @return  processor time to there, ms; most memory, MB
    """
    with tempfile.TemporaryDirectory() as home:
        env = environment(home, {"QT_LOGGING_RULES": "qt.widgets.painting=true"})
        process = subprocess.Popen(command, env=env, stderr=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL)
        for line in process.stderr:
            if b"Flushing" in line:
                break
        else:
            sys.exit(f"{command}: painted nothing")
        end = time.monotonic() + stays
        os.set_blocking(process.stderr.fileno(), False)
        while time.monotonic() < end:
            process.stderr.read()
            time.sleep(0.01)
        os.kill(process.pid, signal.SIGKILL)
        _, _, used = os.wait4(process.pid, 0)
        process.returncode = 0
        process.stderr.close()
    return 1e3 * (used.ru_utime + used.ru_stime), used.ru_maxrss / 1024


def start_rows():
    program = os.path.join(BUILD, "bin/ravnoves")
    rival = [os.path.join(BUILD, "tests/benchmark/bench-ui-empty")]
    rows = []
    for name, command in [("start page", [program]),
                          ("first scene", [program, "--scene", scenes_of(program)[0]])]:
        own, other = [], []
        for _ in range(RUNS):  # in turns, so that both meet the same machine
            own.append(painted(command)[0])
            other.append(painted(rival)[0])
        a, b = statistics.median(own), statistics.median(other)
        rows.append([f"start to the first picture, {name}, processor", f"{a:.0f} ms", f"{b:.0f} ms",
                     f"{a / b:.2f}"])
    return rows


def memory_rows():
    program = os.path.join(BUILD, "bin/ravnoves")
    rival = painted([os.path.join(BUILD, "tests/benchmark/bench-ui-empty")], 1.0)[1]
    rows = []
    for scene in ["start", *scenes_of(program)]:
        own = painted([program, "--scene", scene], 1.0 if QUICK else 3.0)[1]
        rows.append([f"memory at most, {scene}", f"{own:.0f} MB", f"{rival:.0f} MB",
                     f"{own / rival:.2f}"])
    return rows


def main():
    with tempfile.TemporaryDirectory() as home:
        rows = start_rows() + memory_rows()
        for program, more in PROGRAMS:
            rows += rows_of(program, more, home)
    print("| what | here | rival | share |\n|---|---|---|---|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


main()
