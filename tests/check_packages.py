#!/usr/bin/python3
"""A run needs only the packages of packages.txt: check_packages.py WHAT CMAKE NINJA SOURCE BUILD.

WHAT is headers: every header that the program includes belongs to a package of the list, or to
one that the list installs with it. WHAT is configure: CMake configures without the packages of
packages-test.txt."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
TEST_ONLY = ("GTest", "benchmark", "Python3")


def lines_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def packages_with(names):
    """Returns the packages and all packages that apt installs with them."""
    depends = {}
    for line in lines_of("dpkg-query", "-W", "-f", "${Package}\t${Pre-Depends}, ${Depends}\n"):
        name, text = line.split("\t")
        depends[name] = re.findall(r"(?:^|[,|]) *([a-z0-9][a-z0-9+.-]+)", text)
    found, left = set(), list(names)
    while left:
        name = left.pop()
        if name not in found:
            found.add(name)
            left += depends.get(name, [])
    return found


def headers_of_the_program(ninja, build):
    """Returns the system headers that the objects of the folders src and geometry depend on."""
    headers, ours = set(), False
    for line in lines_of(ninja, "-C", build, "-t", "deps"):
        if line and not line.startswith(" "):
            ours = line.startswith(("src/", "geometry/")) and not line.startswith("src/python/")
        elif ours and line.startswith("    /usr/"):
            headers.add(os.path.realpath(line.strip()))
    return headers


def check_headers(ninja, source, build):
    headers = headers_of_the_program(ninja, build)
    assert len(headers) > 100, f"only {len(headers)} headers; is the program built?"
    listed = packages_with(Path(source, "packages.txt").read_text().split())
    faults = set()
    for line in lines_of("dpkg-query", "-S", *headers):
        owners, header = line.split(": ", 1)
        if not {owner.split(":")[0] for owner in owners.split(", ")} & listed:
            faults.add(f"{owners} (for {header})")
    return [f"packages.txt lacks {fault}" for fault in sorted(faults)]


def check_configure(cmake, source):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [cmake, "-S", source, "-B", folder, "--preset", "release",
             *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in TEST_ONLY)],
            check=False, capture_output=True, text=True)
    return [] if done.returncode == 0 else [done.stdout + done.stderr]


def main():
    what, cmake, ninja, source, build = sys.argv[1:]
    if what == "headers" and not shutil.which("dpkg-query"):
        sys.exit(SKIPPED)
    faults = check_headers(ninja, source, build) if what == "headers" else check_configure(cmake, source)
    sys.exit("\n".join(faults) if faults else 0)


main()
