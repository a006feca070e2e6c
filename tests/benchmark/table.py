#!/usr/bin/env python3
"""Prints the table of speeds and memory, each beside what a user would pick instead.

    tests/benchmark/table.py [BUILD] [--quick | --long]     BUILD: build/benchmark, of the preset
                                                            `benchmark`
--long: batches of a million cases and studies of a hundred million samples, some ten minutes more.
Frames are timed three times; the run of the middle share counts.

Absolute times move by a factor of two on a shared machine; the shares, each of two times of one
run, do not. Every program of PROGRAMS prints lines `name | value | rival | share`; start and the
window's memory are measured here, on the program itself.
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
LONG = "--long" in sys.argv
STEPS = "60" if QUICK else "300"
RUNS = 5 if QUICK else 21
FRAME_TURNS = 1 if QUICK else 3
HERE = os.path.dirname(os.path.abspath(__file__))

# Program of the benchmarks, its arguments, and what it finds in the environment.
PROGRAMS = [
    (["bench-core"], {}),
    (["bench-ui-frames", "--steps", STEPS], {}),
    (["bench-ui-frames", "--steps", STEPS, "--size", "1920x1080"], {}),
    (["bench-ui-frames", "--steps", STEPS], {"QT_SCALE_FACTOR": "2"}),
]


def scenes_of(program):
    """As the program lists them: a name that none has makes it say all."""
    with tempfile.TemporaryDirectory() as home:
        rejected = subprocess.run([program, "--screenshot", os.devnull, "--scene", "?"],
                                 env=environment(home, {}), stderr=subprocess.PIPE, text=True).stderr
    listed = re.search(r"must be one of (.*), got \?", rejected).group(1).split(", ")
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


def command_rows():
    cases = "1000" if QUICK else "1000000" if LONG else "20000"
    printed = subprocess.run(
        [sys.executable, os.path.join(HERE, "command_line.py"),
         os.path.join(BUILD, "bin/ravnoves-cli"), str(3 * RUNS), cases],
        text=True, stdout=subprocess.PIPE, check=True).stdout
    return [[part.strip() for part in line.split("|")] for line in printed.splitlines()]


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
        rows.append([f"start to the first picture, {name} (rival: an empty chart's window)",
                     f"{a:.0f} ms", f"{b:.0f} ms", f"{a / b:.2f}"])
    return rows


def memory_rows():
    program = os.path.join(BUILD, "bin/ravnoves")
    rival = painted([os.path.join(BUILD, "tests/benchmark/bench-ui-empty")], 1.0)[1]
    rows = []
    for scene in ["start", *scenes_of(program)]:
        own = painted([program, "--scene", scene], 1.0 if QUICK else 3.0)[1]
        rows.append([f"memory at most, {scene} (rival: an empty chart's window)",
                     f"{own:.0f} MB", f"{rival:.0f} MB", f"{own / rival:.2f}"])
    return rows


def middle_rows(rows):
    """Of the rows of each name the one of the middle share, of equal shares that of the middle time.

    A neighbour on a shared machine makes a page's frames slow, or the plain window's before it.
    """
    named = {}
    for row in rows:
        named.setdefault(row[0], []).append(row)
    return [sorted(each, key=lambda row: (float(row[3]), float(row[1].split()[0])))[len(each) // 2]
            for each in named.values()]


def frames_table(rows):
    """Of the rows of frames: a line for each drag, with its gestures beside each other."""
    gestures = ("wheel", "cursor", "resize")
    lines = {}
    for name, value, rival, share in rows:
        page, sizes = name.removeprefix("frame p95, ").rsplit(", ", 1)
        if sizes == "scale 2":
            page, size = page.rsplit(", ", 1)
            sizes = f"{size}, {sizes}"
        gesture = next((each for each in gestures if page.endswith(", " + each)), "drag")
        page = page.removesuffix(", " + gesture)
        line = lines.setdefault((sizes, page), {"value": value, "rival": rival})
        if gesture == "drag":
            line["value"] = value
        line[gesture] = share
    head = "| 95th percentile of frames | drag | plain window | drag | wheel | cursor | resize |"
    printed = [head, "|---|---:|---:|---:|---:|---:|---:|"]
    for (sizes, page), line in lines.items():
        shares = [line.get(each, "") for each in ("drag", *gestures)]
        printed.append("| " + " | ".join([f"{page}, {sizes.replace('x', '×')}", line["value"],
                                          line["rival"], *shares]) + " |")
    return printed


def print_tables(rows):
    frames = [row for row in rows if row[0].startswith("frame p95, ")]
    print("| what | here | rival | share |\n|---|---:|---:|---:|")
    for row in rows:
        if row not in frames:
            print("| " + " | ".join(row) + " |")
    print()
    print("\n".join(frames_table(frames)))


def main():
    with tempfile.TemporaryDirectory() as home:
        rows = start_rows() + command_rows() + memory_rows()
        for program, more in PROGRAMS:
            turns = FRAME_TURNS if program[0] == "bench-ui-frames" else 1
            rows += middle_rows([row for _ in range(turns) for row in rows_of(program, more, home)])
    print_tables(rows)


main()
