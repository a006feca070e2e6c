#!/usr/bin/env python3
"""Changes one sign, operator or function of a formula of core at a time and sees whether a test
notices. Works on the sources of a clean clone and puts each back; prints the survivors.

usage: tests/mutations/mutate.py [--count N] [--seed N] [--preset NAME] [--list]
"""

import argparse
import collections
import hashlib
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Folders of core without formulas of a scene: they read, write and list, or are measured by the tests
# of methods, each against another.
WITHOUT_FORMULAS = {"bibliography", "case-file", "drawing", "methods", "scenes"}
FOLDERS = sorted(path.name for path in (ROOT / "core").iterdir()
                 if path.is_dir() and path.name not in WITHOUT_FORMULAS)
# Folders of tests, each a program.
TESTS = sorted({path.parent.name for path in (ROOT / "tests" / "core").glob("*/*_test.cpp")})
# What is not a formula: reading, writing, words, drawings.
PASSED_OVER = re.compile(r"scene|fields|presets|formulas|study_file|torque_table|drawing|sha256")
# Neither words nor the counting of work is one.
NO_FORMULA = re.compile(r'"|std::string|throw |\bwork_|\bcost\(|\.reserve\(')
# Changes that no answer shows: what they touch only saves work. By the line as it is.
OF_WORK = {
    "abs(slope_left) + abs(slope_right) > curvature * h": "a search that is passed over finds nothing",
    "most - least - search_.enough": "steers a search whose finds are judged for themselves",
    "(to - from) / (8 * workers.size())": "how many samples a worker takes at a time",
    "seconds > 2.0 * wanted": "how many samples go between two saves",
    "static_cast<long>(search_.dimensions) + 4 * exchanges + 8": "counts the work of an exchange",
    "turn_of(result.angle + pi)": "half a turn is the same place either way round",
    "p.slope(t) + w * c, 2 * p.c2": "a slope of Newton's steps: what they find is judged by its value",
    "i < 100 && high - low > 1e-12": "how often an interval is halved",
    "2 * static_cast<std::size_t>(max_order) + 8": "samples are doubled until two sets agree",
    "turn_of(result.remaining_angle + pi)": "half a turn is the same place either way round",
    "-a.key - limit": "all placings prove what the exchanges found before: no case is "
                        "known where they find more",
    "each / search_.rounding": "placings that are alike are compared once; the exchanges find the best "
                               "without them",
    "(maximum - min_lambda) / scans": "where a search begins",
    "root(beyond, time[i] - time[i - 1]": "an interval around one root; a longer one has the same",
    "std::abs(next - t) < previous_width": "when Newton's steps give way to halves; the root is the same",
    "turn_of(angle_ + place)": "holes stand evenly on both sides of the middle",
    "one + std::remainder(other[w] - one": "a difference is squared; its size has a test of its own",
    "(preload + 0.5 * spring.free_length)": "how far rounding may bring a square below zero",
    "std::hypot(p.x - a.x, p.y - a.y)": "no guide that can be drawn has a chord of no length",
}
CHANGES = [(" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "),
           ("std::sin(", "std::cos("), ("std::cos(", "std::sin(")]


def candidates(folder):
    for path in sorted((ROOT / "core" / folder).glob("*.cpp")):
        if PASSED_OVER.search(path.stem):
            continue
        for number, line in enumerate(path.read_text().splitlines()):
            code = line.split("//")[0]
            if any(part in code for part in OF_WORK):
                continue
            if NO_FORMULA.search(code) or code.lstrip().startswith(("#", "*")):
                continue
            for old, new in CHANGES:
                for found in re.finditer(re.escape(old), code):
                    yield path, number, found.start(), old, new


def choose(count, seed):
    """As many of each folder, each time of another line; which ones, only the lines themselves say, so
    that a change elsewhere leaves the choice as it was."""
    def lot(candidate):
        path, number, start, old, _ = candidate
        line = path.read_text().splitlines()[number].strip()
        return hashlib.sha256(f"{seed} {path.name} {line} {start} {old}".encode()).digest()
    queues = [collections.deque(sorted(candidates(folder), key=lot)) for folder in FOLDERS]
    chosen, lines = [], set()
    while len(chosen) < count and any(queues):
        for queue in queues:
            while queue and (queue[0][0], queue[0][1]) in lines:
                queue.popleft()
            if queue and len(chosen) < count:
                lines.add(queue[0][:2])
                chosen.append(queue.popleft())
    return chosen


def run(*command, limit=None):
    try:
        return subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None


def build(preset, tests):
    """The test programs, and what they are made of; nothing else is run here."""
    return run("cmake", "--build", "--preset", preset, "--target", *(path.name for path in tests))


def noticed_by(tests):
    """The first test program that fails."""
    for program in tests:
        done = run(str(program), "--gtest_brief=1", "--gtest_fail_fast", limit=300)
        if done is None:
            return f"{program.name} (no end)"
        if done.returncode != 0:
            failed = re.search(r"\[  FAILED  \] (\S+)", done.stdout)
            return f"{program.name}: {failed.group(1) if failed else done.returncode}"
    return None


def caught_by(preset, tests, own):
    """What notices the change: the tests of its folder first, which alone are built for that."""
    own_tests = [path for path in tests if path.name == f"test-core-{own}"]
    others = [path for path in tests if path not in own_tests]
    for some in (own_tests, others):
        if build(preset, some).returncode != 0:
            return "the compiler"
        caught = noticed_by(some)
        if caught is not None:
            return caught
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--preset", default="mutations")
    parser.add_argument("--list", action="store_true", help="only print what would be changed")
    options = parser.parse_args()
    chosen = choose(options.count, options.seed)

    def describe(path, number, at, old, new):
        line = path.read_text().splitlines()[number]
        changed = line[:at] + new + line[at + len(old):]
        return f"{path.relative_to(ROOT)}:{number + 1}: {line.strip()}  →  {changed.strip()}"

    if options.list:
        for mutation in chosen:
            print(describe(*mutation))
        return 0
    if run("git", "status", "--porcelain").stdout.strip():
        sys.exit("the sources have changes that are not committed: use a clean clone")
    folder = ROOT / "build" / options.preset / "tests" / "core"
    tests = [folder / f"test-core-{name}" for name in TESTS]
    made = run("cmake", "--preset", options.preset)
    if made.returncode != 0 or build(options.preset, tests).returncode != 0:
        sys.exit("the program does not build")
    failed = noticed_by(tests)
    if failed is not None:
        sys.exit(f"the tests fail before anything is changed: {failed}")

    survivors = []
    for count, mutation in enumerate(chosen, 1):
        path, number, at, old, new = mutation
        before = path.read_text()
        text = describe(*mutation)
        lines = before.split("\n")
        lines[number] = lines[number][:at] + new + lines[number][at + len(old):]
        try:
            path.write_text("\n".join(lines))
            caught = caught_by(options.preset, tests, path.parent.name)
        finally:
            path.write_text(before)
        print(f"{count:3} {caught or 'SURVIVED'}  {text}", flush=True)
        if caught is None:
            survivors.append(text)
    build(options.preset, tests)
    print(f"\n{len(chosen) - len(survivors)} of {len(chosen)} caught")
    for text in survivors:
        print("survived:", text)
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
