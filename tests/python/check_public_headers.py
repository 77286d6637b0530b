# SPDX-License-Identifier: BSD-3-Clause
"""Every installed header compiles on its own, without warnings, and without CGAL, FCL or nlohmann's JSON behind it; and
all of them together.

    check_public_headers.py BUILD_DIRECTORY WORK_DIRECTORY COMPILER

Most of a header's time goes to what it includes of Eigen and OMPL. That is compiled once and put in front of those
headers that include just the same: what is in front hides nothing that a header lacks if it brings all of it itself.
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

FORBIDDEN = ("/CGAL/", "/fcl/", "/nlohmann/", "/nlopt", "/yaml-cpp/")
SYSTEM = ("eigen3", "ompl")
FRONTS = (("Eigen/Core", "ompl/geometric/PathGeometric.h"), ("Eigen/Core", "Eigen/Geometry"), ("Eigen/Core",))


class Compiler:
    def __init__(self, program, root, work):
        found = subprocess.run(["pkg-config", "--cflags-only-I", *SYSTEM], check=True, capture_output=True, text=True)
        self.command = [program, "-std=c++17", "-Wall", "-Wextra", "-Werror", f"-I{root}",
                        *found.stdout.replace("-I", "-isystem").split()]  # where Debian puts them
        self.work = work
        for number, front in enumerate(FRONTS):
            text = work / f"front{number}.h"
            text.write_text(including(front, "<{}>"))
            subprocess.run([*self.command, "-x", "c++-header", text, "-o", f"{text}.gch"], check=True)

    def faults(self, title, headers, brought=frozenset()):
        """What is wrong with headers that are compiled in this order; empty if nothing is.

        brought: all that they include, directly or not
        """
        stem = self.work / title.replace("/", ".")
        source, dependencies = stem.with_suffix(".cpp"), stem.with_suffix(".d")
        source.write_text(including(headers, '"{}"'))
        front = next((["-include", self.work / f"front{number}.h"] for number, front in enumerate(FRONTS)
                      if brought.issuperset(front)), [])
        done = subprocess.run([*self.command, *front, "-fsyntax-only", "-MD", "-MF", dependencies, source],
                              capture_output=True, text=True)
        if done.returncode != 0:
            return [f"{title}: {done.stderr}"]
        text = dependencies.read_text()
        return [f"{title} brings in {library}" for library in FORBIDDEN if library in text]


def including(headers, form):
    return "".join(f"#include {form.format(header)}\n" for header in headers)


def brought_by(header, included):
    """All that a header includes, directly or through other installed headers."""
    brought = set()
    waiting = [header]
    while waiting:
        for name in included.get(waiting.pop(), ()):
            if name not in brought:
                brought.add(name)
                waiting.append(name)
    return brought


def main(build, work, program):
    work = pathlib.Path(work).resolve()
    shutil.rmtree(work, ignore_errors=True)
    subprocess.run(["cmake", "--install", build, "--prefix", work / "prefix", "--component", "dev"], check=True,
                   stdout=subprocess.DEVNULL)
    root = work / "prefix" / "include" / "narrows"
    included = {path.relative_to(root).as_posix(): re.findall(r'^#include [<"](.+)[>"]', path.read_text(), re.MULTILINE)
                for path in sorted(root.rglob("*.h"))}
    assert len(included) > 100, f"only {len(included)} headers were installed"
    compiler = Compiler(program, root, work)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        together = pool.submit(compiler.faults, "all headers", included)
        alone = pool.map(lambda name: compiler.faults(name, [name, name], brought_by(name, included)), included)
        faults = sum(alone, together.result())
    for front in work.glob("*.gch"):
        front.unlink()  # a hundred megabytes each
    print("\n".join(faults) or f"{len(included)} headers stand on their own")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
