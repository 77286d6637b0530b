# SPDX-License-Identifier: BSD-3-Clause
"""Builds tests/consumer against Narrows as others get it and looks at what its programs print.

    check_consumer.py installed|package BUILD_DIRECTORY SOURCE_DIRECTORY WORK_DIRECTORY
    check_consumer.py subproject BUILD_DIRECTORY SOURCE_DIRECTORY WORK_DIRECTORY
    check_consumer.py machine PREFIX SOURCE_DIRECTORY WORK_DIRECTORY

installed: `cmake --install` into a prefix; package: the .deb that CPack makes, unpacked; subproject: FetchContent, only
configured (its libraries are those of this build, once more); machine: the package is installed on this machine, in PREFIX
(tests/consumer/check-clean-machine). Where there is a prefix, a program is also built with what pkg-config says. The
environment's ompl_DIR says which OMPL is meant, as it does to CMake.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys


def run(*command, **options):
    print("$", *command, flush=True)
    return subprocess.run([str(word) for word in command], check=True, **options)


def output(*command):
    return run(*command, capture_output=True, text=True).stdout


def prefix_of(kind, build, work):
    """Where Narrows was put."""
    if kind == "machine":
        return build
    if kind == "installed":
        run("cmake", "--install", build, "--prefix", work / "prefix", "--component", "dev")
        return work / "prefix"
    run("cpack", "--config", build / "CPackConfig.cmake", "-G", "DEB", "-B", work / "packages",
        "-D", "CPACK_COMPONENTS_ALL=dev")
    package, = (work / "packages").glob("libnarrows-dev_*.deb")
    fields = output("dpkg-deb", "--field", package)
    assert "Package: libnarrows-dev" in fields and "libompl-dev" in fields, fields
    run("dpkg-deb", "-x", package, work / "root")
    (work / "depends").write_text(output("dpkg-deb", "--field", package, "Depends"))
    return work / "root" / "usr"


def configure(source, work, *definitions):
    run("cmake", "-S", source / "tests" / "consumer", "-B", work / "build", "-D", "CMAKE_BUILD_TYPE=Release",
        "-D", f"OWN_ROBOT={source / 'examples' / '08_own_robot.cpp'}", *definitions)


def dependencies_of(packages):
    """The packages with all that they depend on, as far as it is installed."""
    depends, provided = {}, {}
    for line in output("dpkg-query", "-W", "-f", "${Package}\\t${Pre-Depends}, ${Depends}\\t${Provides}\\n").splitlines():
        name, wanted, provides = line.split("\t")
        depends[name] = [re.split(r"[ (:]", choice.strip())[0] for choice in re.split(r"[,|]", wanted)]
        for other in provides.split(","):
            provided.setdefault(re.split(r"[ (]", other.strip())[0], []).append(name)
    found, open_ = set(), list(packages)
    while open_:
        name = open_.pop()
        if name and name not in found:
            found.add(name)
            open_ += depends.get(name, []) + provided.get(name, [])
    return found


def owners_of(files):
    """The packages that the files belong to; those that belong to none are this project's."""
    listed = subprocess.run(["dpkg", "-S", *sorted(files)], capture_output=True, text=True).stdout
    return {line.split(":")[0] for line in listed.splitlines() if not line.startswith("diversion")}


def check_depends(depends, programs):
    """Nothing that the programs were compiled with and run on comes from a package that Depends does not bring."""
    files = set()
    for listing in programs.rglob("*.o.d"):
        files |= {os.path.realpath(word) for word in listing.read_text().split() if word.startswith("/")}
    for program in ("plan", "own_robot", "kernel_only"):
        files |= {os.path.realpath(path) for path in re.findall(r"=> (/\S+)", output("ldd", programs / program))}
    names = [word.split()[0] for word in depends.split(",")]
    missing = owners_of(files) - dependencies_of(names + ["build-essential"])
    assert len(files) > 1000 and not missing, f"Depends lacks what brings {sorted(missing)}"


def assert_plans(source, program, planner):
    scenario = source / "experiments" / "scenarios" / "hppm_case1.yaml"
    assert output(program, scenario, planner) == f"{planner}: Exact solution\n"


def build_and_look(source, work):
    run("cmake", "--build", work / "build")
    programs = work / "build"
    assert output(programs / "kernel_only") == "tip at 1 1\n"
    for planner in ("hppm", "rrtconnect", "threader"):
        assert_plans(source, programs / "plan", planner)
    for scene in ("scara", "distance"):
        assert f"{scene}: solved, least clearance 0.0" in output(programs / "own_robot", scene)


def build_by_pkg_config(kind, prefix, source, work):
    package, = prefix.glob("lib/**/pkgconfig/narrows.pc")
    where = [] if kind == "machine" else ["--with-path", package.parent]
    flags = output("pkg-config", *where, "--cflags", "--libs", "narrows")
    assert "-lnarrows_kernel" in flags and "include/narrows" in flags, flags
    program = work / "plan_by_pkg_config"
    libraries = package.parent.parent  # where the loader looks, if they are shared
    # C++17 last: Debian's ompl.pc says 14.
    run("c++", source / "tests" / "consumer" / "plan.cpp", "-o", program, *flags.split(), f"-Wl,-rpath,{libraries}",
        "-O1", "-std=c++17")
    assert_plans(source, program, "hppm")


def main(kind, build, source, work):
    build, source, work = (pathlib.Path(path).resolve() for path in (build, source, work))
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    if kind == "subproject":
        configure(source, work, "-D", f"NARROWS_SOURCE={source}")
        return
    prefix = prefix_of(kind, build, work)
    configure(source, work, "-D", f"CMAKE_PREFIX_PATH={prefix}")
    build_and_look(source, work)
    if kind == "package":
        check_depends((work / "depends").read_text(), work / "build")
    # What OMPL 2 says to pkg-config, pkg-config cannot read.
    if os.environ.get("ompl_DIR", "/usr/").startswith("/usr/"):
        build_by_pkg_config(kind, prefix, source, work)


if __name__ == "__main__":
    main(*sys.argv[1:])
