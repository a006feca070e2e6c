#!/usr/bin/env python3
"""Runs clang-tidy over our own files of core, ui and app, as many at once as there are cores.

It takes the units that the build would compile: several files each, since most of its time goes into
the headers of Qt and of the standard library, which are read once a unit. Generated code is left out,
and nothing has to be built first. A unit that passed is not checked again until a file that it reads,
or the list of checks, changes.

usage: tests/tidy/tidy.py BUILD-FOLDER [--checks CHECKS] [--clang-tidy PROGRAM] [--jobs NUMBER]
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAYERS = "core|ui|app"


def units(build):
    """The entries of compile_commands.json that are ours: units, and sources that are none's."""
    ours = re.compile(rf"({re.escape(str(build))}/({LAYERS})/.*/Unity/.*)"
                      rf"|({re.escape(str(ROOT))}/({LAYERS})/.*)")
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    return {entry["file"]: entry for entry in entries if ours.fullmatch(entry["file"])}


def read_by(entry):
    """The files that a unit reads."""
    words = [word for word in shlex.split(entry["command"]) if not word.endswith("ccache")]
    # Neither an object file nor the rule that the build itself writes.
    for option in ("-o", "-MF", "-MT"):
        while option in words:
            at = words.index(option)
            del words[at:at + 2]
    words = [word for word in words if word not in ("-c", "-MD")]
    rule = subprocess.run(words + ["-M"], cwd=entry["directory"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    return rule.replace("\\\n", " ").split()[1:]


def as_it_was(stamp):
    """Whether what the unit read when it passed has not changed since; the stamp names it."""
    try:
        passed = stamp.stat().st_mtime
        return all(os.stat(name).st_mtime <= passed for name in stamp.read_text().splitlines())
    except OSError:
        return False


def check(options, build, entry):
    """What clang-tidy finds in a unit; nothing if it passed."""
    name = os.path.relpath(entry["file"], build if entry["file"].startswith(f"{build}/") else ROOT)
    stamp = build / "tests" / "tidy" / (name.replace("/", "-") + ".passed")
    if as_it_was(stamp):
        return ""
    began = time.time()
    # A unit includes sources, and those are no headers.
    checks = ",".join(filter(None, ["-bugprone-suspicious-include", options.checks]))
    done = subprocess.run(
        [options.clang_tidy, "-p", str(build), "--quiet", f"--checks={checks}",
         f"--header-filter=^{ROOT}/({LAYERS})/", entry["file"]],
        check=False, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode != 0:
        # Standard error counts the warnings of others; it says something only where nothing was read.
        return done.stdout or done.stderr
    stamp.parent.mkdir(parents=True, exist_ok=True)
    stamp.write_text("\n".join([str(ROOT / ".clang-tidy"), *read_by(entry)]))
    os.utime(stamp, (began, began))
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--checks", default="",
                        help="on top of .clang-tidy; -clang-analyzer-* leaves the slow analyzer out")
    parser.add_argument("--clang-tidy", default="clang-tidy")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    build = options.build.resolve()
    found = units(build)
    if not found:
        sys.exit(f"{build}/compile_commands.json names none of our sources")
    # A fault of a header is found in each unit that includes it, and said once.
    said, failed = set(), 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as workers:
        for text in workers.map(lambda entry: check(options, build, entry), found.values()):
            failed += bool(text)
            if text and text not in said:
                said.add(text)
                print(text, flush=True)
    print(f"{len(found) - failed} of {len(found)} units passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
