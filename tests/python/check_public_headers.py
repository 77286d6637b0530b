# SPDX-License-Identifier: BSD-3-Clause
"""Every installed header compiles on its own, without warnings, and without CGAL, FCL or nlohmann's JSON behind it.

    check_public_headers.py BUILD_DIRECTORY WORK_DIRECTORY COMPILER
"""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys

FORBIDDEN = ("/CGAL/", "/fcl/", "/nlohmann/", "/nlopt", "/yaml-cpp/")
SYSTEM = ("eigen3", "ompl")


def flags():
    """Where Debian puts what the headers may include."""
    return subprocess.run(["pkg-config", "--cflags-only-I", *SYSTEM], check=True, capture_output=True,
                          text=True).stdout.replace("-I", "-isystem").split()


def faults_of(header, root, work, compiler):
    """What is wrong with one header; empty if nothing is."""
    name = header.relative_to(root).as_posix()
    dependencies = work / (name.replace("/", ".") + ".d")
    source = work / (name.replace("/", ".") + ".cpp")
    source.write_text(f'#include "{name}"\n#include "{name}"\n')
    done = subprocess.run([compiler, "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", f"-I{root}", *flags(),
                           "-MD", "-MF", dependencies, source], capture_output=True, text=True)
    if done.returncode != 0:
        return [f"{name}: {done.stderr}"]
    text = dependencies.read_text()
    return [f"{name} brings in {library}" for library in FORBIDDEN if library in text]


def main(build, work, compiler):
    work = pathlib.Path(work).resolve()
    shutil.rmtree(work, ignore_errors=True)
    subprocess.run(["cmake", "--install", build, "--prefix", work / "prefix", "--component", "dev"], check=True,
                   stdout=subprocess.DEVNULL)
    root = work / "prefix" / "include" / "narrows"
    headers = sorted(root.rglob("*.h"))
    assert len(headers) > 100, f"only {len(headers)} headers were installed"
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = sum(pool.map(lambda header: faults_of(header, root, work, compiler), headers), [])
    print("\n".join(faults) or f"{len(headers)} headers stand on their own")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
