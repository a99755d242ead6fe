# SPDX-License-Identifier: MIT
"""Reads a trajectory with the programs it is written for, ASE and MDAnalysis.

The file is trajectory_test's: three frames of eight particles.  What each program has
read is compared with the words of the file.  Exit status 77: neither is installed.
"""
import sys
import warnings

warnings.simplefilter("ignore")  # theirs, about themselves


def frames_of(path):
    """Per frame: the box's lengths, and the words of each particle's line."""
    lines = open(path).read().splitlines()
    while lines:
        count = int(lines[0])
        lattice = [float(x) for x in lines[1].split('"')[1].split()]
        yield lattice[::4], [line.split() for line in lines[2 : 2 + count]]
        lines = lines[2 + count :]


def check(what, is_so):
    if not is_so:
        sys.exit(f"{what} is not as it stands in the file")


def check_ase(path, frames):
    from ase.io import read

    images = read(path, index=":", format="extxyz")
    check("ASE: the number of frames", len(images) == len(frames))
    for atoms, (box, rows) in zip(images, frames):
        check("ASE: the box", list(atoms.cell.lengths()) == box)
        check("ASE: pbc", all(atoms.pbc))
        symbols = [row[0] for row in rows]
        check("ASE: species", atoms.get_chemical_symbols() == symbols)
        # to the bit: both read the 17 digits to the nearest double
        for name, first, width in (("positions", 1, 3), ("velo", 4, 3),
                                   ("radius", 7, 1), ("mass", 8, 1), ("id", 9, 1)):
            read_in = atoms.arrays[name].reshape(len(rows), width)
            words = [row[first : first + width] for row in rows]
            check(f"ASE: {name}", [[float(w) for w in row] for row in words]
                  == [[float(x) for x in row] for row in read_in])


def check_mdanalysis(path, frames):
    import MDAnalysis
    import numpy

    universe = MDAnalysis.Universe(path)
    check("MDAnalysis: the number of frames",
          len(universe.trajectory) == len(frames))
    for step, (_, rows) in zip(universe.trajectory, frames):
        names = [row[0] for row in rows]
        check("MDAnalysis: species", list(universe.atoms.names) == names)
        # it keeps single precision
        words = numpy.array([row[1:4] for row in rows], dtype=float)
        check("MDAnalysis: positions",
              (step.positions == words.astype(numpy.float32)).all())


def main():
    path = sys.argv[1]
    frames = list(frames_of(path))
    check("the number of frames", len(frames) == 3)
    missing = 0
    for name, check_one in (("ASE", check_ase), ("MDAnalysis", check_mdanalysis)):
        try:
            check_one(path, frames)
            print(f"{name} reads {path}")
        except ImportError as reason:
            print(f"{name} is not here to read {path}: {reason}")
            missing += 1
    sys.exit(77 if missing == 2 else 0)


main()
