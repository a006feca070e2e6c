#!/usr/bin/env python3
"""Prints what a source file includes, as a rule of make for STAMP.

usage: tests/tidy/includes.py COMPILE-COMMANDS SOURCE STAMP
"""

import json
import shlex
import subprocess
import sys

commands, source, stamp = sys.argv[1:]
with open(commands, encoding="utf-8") as file:
    entry = next(entry for entry in json.load(file) if entry["file"] == source)
words = [word for word in shlex.split(entry["command"]) if not word.endswith("ccache")]
# Neither an object file nor the rule that the build itself writes.
for option in ("-o", "-MF", "-MT"):
    while option in words:
        at = words.index(option)
        del words[at:at + 2]
words = [word for word in words if word not in ("-c", "-MD")]
sys.exit(subprocess.run(words + ["-M", "-MT", stamp], cwd=entry["directory"], check=False).returncode)
