# SPDX-License-Identifier: MIT
"""A tree of its own to be mutated, its build, and one test's run.

It is built with one path of code (BRINK_PATHS=OFF) for AVX2 and FMA: what is written
for other processors is not mutated.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import tempfile
import threading

SHARE = "0.05"  # of the work of tests that take it from BRINK_TEST_SHARE
QUIET = {"CK_FORK": "no", "CK_VERBOSITY": "silent", "BRINK_TEST_SHARE": SHARE}
MAP_SIZE = 4096  # mutants_switch.c


class Build:
    def __init__(self, source, folder, *options):
        self.source, self.tree = source, folder / "tree"
        self.build, self.work = folder / "build", folder / "work"
        self.work.mkdir(parents=True, exist_ok=True)
        for name in ("CMakeLists.txt", "kernels", "sim", "tests"):
            self._copy(source / name)
        for pattern in ("fuzz/*.*", "proofs/*.*"):  # CMake asks for them; not the corpora
            for path in source.glob(pattern):
                self._copy(path)
        self._put(self.tree / "kernels/mutants_switch.c",
                  (source / "tests/mutants_switch.c").read_bytes())
        self._configure(options)
        commands = json.loads((self.build / "compile_commands.json").read_text())
        self.commands = {c["file"]: shlex.split(c["command"]) for c in commands}

    def _copy(self, path):
        if path.is_dir():
            for child in path.iterdir():
                self._copy(child)
        elif not path.is_symlink():
            self._put(self.tree / path.relative_to(self.source),
                      path.read_bytes())

    @staticmethod
    def _put(path, content):
        """As little as need be: what has not changed is not built anew."""
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_bytes() != content:
            path.write_bytes(content)

    def _configure(self, options):
        done = subprocess.run(
            ["cmake", "-G", "Ninja", "-S", self.tree, "-B", self.build,
             "-DBRINK_PATHS=OFF", "-DBRINK_TESTS=ON", "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_C_FLAGS_RELEASE=-O1", "-DCMAKE_C_FLAGS=-w -mavx2 -mfma",
             "-DCMAKE_EXE_LINKER_FLAGS=-Wl,--wrap=_ck_assert_failed", *options],
            capture_output=True, text=True, check=False)
        if done.returncode:
            raise SystemExit(done.stderr)

    # --- The mutated file ----------------------------------------------------

    def write(self, name, text):
        (self.tree / name).write_bytes(text.encode("latin-1"))

    def restore(self, name):
        self._put(self.tree / name, (self.source / name).read_bytes())

    def make(self, targets, jobs):
        """What the compiler has to say; None if all is well."""
        done = subprocess.run(
            ["ninja", "-C", self.build, f"-j{jobs}", *targets],
            capture_output=True, text=True, check=False)
        return done.stdout if done.returncode else None

    def units(self, name):
        """The library's files that are compiled with it."""
        path = self.tree / name
        if path.suffix == ".c":
            return [str(path)]
        listed = subprocess.run(["ninja", "-C", self.build, "-t", "deps"],
                                capture_output=True, text=True, check=True).stdout
        found = []
        for paragraph in listed.split("\n\n"):
            files = [os.path.realpath(self.build / line.strip())
                     for line in paragraph.splitlines()[1:]]
            if str(path) in files:
                found += [f for f in files
                          if f in self.commands and "/tests/" not in f]
        return sorted(found, key=lambda f: (pathlib.Path(f).stem != path.stem, f))

    def arguments(self, unit):
        """What a parser needs to know of how it is compiled."""
        words = self.commands[unit]
        return [w for w in words if re.match(r"-[ID]|-std|-m", w)] + [
            flag for k, w in enumerate(words[:-1]) if w == "-isystem"
            for flag in (w, words[k + 1])]

    def code(self, unit):
        """The object code it becomes when optimised; None if it does not."""
        words = [w for w in self.commands[unit] if w != "-O1"]
        with tempfile.TemporaryDirectory(dir=self.work) as folder:
            out = pathlib.Path(folder) / "code.o"
            words[words.index("-o") + 1] = str(out)
            done = subprocess.run([*words, "-O2"], cwd=self.build,
                                  capture_output=True, check=False)
            return None if done.returncode else out.read_bytes()

    # --- A run ---------------------------------------------------------------

    def reached(self, test, seconds):
        """Seconds of a processor taken and the numbers of the functions reached by
        the test without a mutant; None if it fails."""
        with tempfile.TemporaryDirectory(dir=self.work) as folder:
            marks = pathlib.Path(folder) / "reached"
            marks.write_bytes(bytes(MAP_SIZE))
            passed, took = self.run(test, 0, seconds, BRINK_MUTANT_REACHED=str(marks))
            where = {k for k, mark in enumerate(marks.read_bytes()) if mark}
            return (took, where) if passed else None

    def passes(self, test, mutant, seconds):
        return self.run(test, mutant, seconds)[0]

    def run(self, test, mutant, seconds, **more):
        """Whether it passes in so many seconds of processor time, and what it took of
        them; where that is not what it uses up, in some more of the clock on the wall."""
        with tempfile.TemporaryDirectory(dir=self.work) as folder:
            environment = {**os.environ, **QUIET, **more, "TMPDIR": folder,
                           "BRINK_MUTANT": str(mutant),
                           "BRINK_MUTANT_SECONDS": str(int(seconds) + 1)}
            process = subprocess.Popen(
                [self.build / "tests" / test], cwd=folder, env=environment,
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL, start_new_session=True)

            def end():
                try:
                    os.killpg(process.pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass

            patience = threading.Timer(4 * seconds + 20, end)
            patience.start()
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            patience.cancel()
            end()  # what it may have left behind
            return process.returncode == 0, used.ru_utime + used.ru_stime

    def clear(self):
        shutil.rmtree(self.work, ignore_errors=True)
