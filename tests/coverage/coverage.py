#!/usr/bin/env python3
"""Lines that the tests reach, from a build with --coverage whose tests have run.

usage: tests/coverage/coverage.py BUILD-FOLDER [--folder core=97 --folder ui/*/model=90 …] [--missed]

Each --folder is a pattern of source folders and the least share in percent; the exit status is 1
where one has less. --missed lists the lines that no test reaches.
"""

import argparse
import collections
import fnmatch
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def gcov(data_files):
    """What gcov says of each source file, one JSON document per data file."""
    for start in range(0, len(data_files), 40):
        text = subprocess.run(["gcov", "--json-format", "--stdout", "--preserve-paths"] +
                              [str(path) for path in data_files[start:start + 40]],
                              cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              text=True, check=True).stdout
        for line in text.splitlines():
            if line.startswith("{"):
                yield from json.loads(line)["files"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--folder", action="append", default=[])
    parser.add_argument("--missed", action="store_true")
    options = parser.parse_args()
    data = sorted(options.build.resolve().rglob("*.gcda"))
    if not data:
        sys.exit(f"no coverage data below {options.build}: build with --coverage and run the tests")

    reached = collections.defaultdict(dict)  # file: line: how often
    for source in gcov(data):
        path = pathlib.Path(source["file"])
        path = path if path.is_absolute() else ROOT / path
        try:
            name = str(path.resolve().relative_to(ROOT))
        except ValueError:
            continue  # of the system
        if name.startswith(("core/", "ui/", "app/")):
            lines = reached[name]
            for line in source["lines"]:
                number = line["line_number"]
                lines[number] = lines.get(number, 0) + line["count"]

    status = 0
    for wish in options.folder or ["core=0"]:
        pattern, least = wish.split("=")
        files = [name for name in reached
                 if any(fnmatch.fnmatch(str(folder), pattern)
                        for folder in pathlib.PurePath(name).parents)]
        total = sum(len(reached[name]) for name in files)
        hit = sum(1 for name in files for count in reached[name].values() if count)
        share = 100.0 * hit / total if total else 0.0
        print(f"{pattern}: {share:.2f} % of {total} lines in {len(files)} files (at least {least} %)")
        status |= share < float(least)
        if options.missed:
            for name in sorted(files):
                lines = [str(line) for line, count in sorted(reached[name].items()) if not count]
                if lines:
                    print(f"  {name}: {' '.join(lines)}")
    return status


if __name__ == "__main__":
    sys.exit(main())
