# SPDX-License-Identifier: MIT
"""How each tool is asked, and what of its answer counts as a proof.

A tool is a function of the tree, a folder of its own to work in, the proof's file and options;
it gives whether all is proved, and what was said; what it cannot even read is Unread, so that
no mutant is taken for rejected that is only badly written.  What options a file needs it says
itself, in a line `// with: OPTIONS` (`; with:`, `# with:`, `(* with: ... *)`); a mutant may say
others.
"""
import collections
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading

TRANSCRIBE = pathlib.Path(__file__).parent.parent / "tests/transcribe.py"
LONGEST = 3600  # seconds, for one proof, on a machine that has other things to do as well


class Unread(Exception):
    """What a tool said of what is no proof, good or bad."""


def options_of(file):
    """The words after every `with:` in the first lines of a file."""
    head = "\n".join(file.read_text().splitlines()[:12])
    said = re.findall(r"with: (.*?)(?:\*\)|\*/)?$", head, re.MULTILINE)
    return shlex.split(" ".join(said))


def run(arguments, folder):
    done = subprocess.run([str(a) for a in arguments], cwd=folder, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LONGEST)
    return done.returncode, done.stdout


# The real numbers of Coq's library, and classical logic.
NO_COQ = re.compile("Syntax error|not found in the current environment|Unable to locate library")
AXIOMS = {"ClassicalDedekindReals.sig_forall_dec", "ClassicalDedekindReals.sig_not_dec",
          "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"}


def coqc(part, build):
    """Its status, and what was said, if Coq could read it."""
    status, said = run(["coqc", "-w", "-ambiguous-paths", "-Q", ".", "Brink", part], build)
    if NO_COQ.search(said):
        raise Unread(said)
    return status, said


class Modules:
    """What Coq makes of a proof's parts, one after the other.  Claims share parts, and their
    mutants most of them: what was made in this run of the same text after the same parts is
    taken again."""
    store = tempfile.TemporaryDirectory()
    locks = collections.defaultdict(threading.Lock)

    def __init__(self, build):
        self.build, self.digest = build, hashlib.sha1()

    def add(self, name, text):
        """Its status and what was said."""
        self.digest.update(f"{name}\n{text}".encode())
        key = self.digest.hexdigest()
        (self.build / name).write_text(text)
        made = pathlib.Path(self.store.name) / key
        with self.locks[key]:
            if made.exists():
                shutil.copy(made / f"{name}o", self.build)
                return 0, (made / "said").read_text()
            status, said = coqc(name, self.build)
            if status == 0:
                made.mkdir()
                shutil.copy(self.build / f"{name}o", made)
                (made / "said").write_text(said)
            return status, said


def rests_on_axioms_alone(said):
    """Whether what Print Assumptions says is no more than the real numbers and classical logic."""
    rests_on = re.findall(r"^([\w.]+)(?= :|$)", said.partition("Axioms:")[2], re.MULTILINE)
    return set(rests_on) <= AXIOMS


def coq(tree, build, file, options):
    """Every theorem of the file, asked what they rest on: no axiom but the reals' and those
    of classical logic."""
    theorems = re.findall(r"^Theorem (\w+)", file.read_text(), re.MULTILINE)
    asked = f"Definition all_of_them := ({', '.join(theorems)}).\nPrint Assumptions all_of_them.\n"
    said, modules = "", Modules(build)
    for part in [tree / "proofs" / p for p in options] + [file]:
        status, said = modules.add(part.name, part.read_text() + (asked if part == file else ""))
        if status:
            return False, f"{part.name}: {said}"
    return bool(theorems) and rests_on_axioms_alone(said), said


def without_proofs(text, start):
    """Its proofs that end after `start` left out."""
    def left_out(proof):
        return proof[0] if proof.end() <= start else "Proof using All. Admitted."
    return re.sub(r"^Proof\b.*?\bQed\.", left_out, text, flags=re.DOTALL | re.MULTILINE)


def refuted(tree, changed, build, file, refutation):
    """Whether a changed file says what is false, and not only its proof is broken.  REFUTATION is
    Coq: it names a theorem (`refutes: NAME`) and proves, as `is_false`, that what it says now has
    a counterexample.  It may rest on what stands before the change and not on what comes after."""
    is_changed, modules = False, Modules(build)
    for part in [tree / "proofs" / p for p in options_of(file)] + [tree / "proofs" / file.name]:
        text, before = (changed / "proofs" / part.name).read_text(), part.read_text()
        start = 0 if is_changed else len(os.path.commonprefix([text, before]))
        is_changed = is_changed or text != before
        status, said = modules.add(part.name, without_proofs(text, start))
        if status:
            raise Unread(said)
    name = re.search(r"refutes: (\w+)", refutation.read_text())[1]
    asked = (f"Definition refuted : ltac:(let T := type of {name} in exact (T -> False)) := "
             "is_false.\nPrint Assumptions refuted.\n")
    for part in [refutation.parent / p for p in options_of(refutation)] + [refutation]:
        module = f"{part.stem.replace('.', '_').replace('-', '_')}.v"
        status, said = modules.add(module, part.read_text() + (asked if part == refutation else ""))
        if status:
            return False, said
    return rests_on_axioms_alone(said), said


# A rewriting that a Gappa script asks for is a hypothesis of its certificate: these prove it.
HINTS = """Require Import Reals Lra Gappa.Gappa_library.
(* What holds of the square root of a variable that is not 0: it is positive, and its square. *)
Ltac root x := match goal with H : sqrt x <> 0%R |- _ =>
  let P := fresh in let Q := fresh in let y := fresh in let E := fresh in
  assert (P : (0 <= x)%R)
    by (destruct (Rle_or_lt 0 x); [assumption | exfalso; apply H, sqrt_neg_0; lra]);
  assert (Q := sqrt_sqrt x P); remember (sqrt x) as y eqn:E; clear E; subst x end.
Ltac hint := intros; unfold Float1 in *;
  repeat (match goal with H : sqrt ?x <> 0%R |- _ => is_var x; root x end);
  field; repeat split; try assumption; try lra; intro;
  repeat match goal with H : _ <> _ |- _ => apply H end; lra.
"""
HYPOTHESIS = re.compile(r"^Hypothesis (a\d+) : (.*)\.$", re.MULTILINE)


def gappa(tree, build, file, options):
    """The bounds of a script, and their certificate checked by Coq, with no hypothesis left."""
    del tree
    shutil.copy(file, build)
    status, said = run(["gappa", *options, file.name], build)
    if status and "some properties were not satisfied" not in said:
        raise Unread(said)
    if status or "?" in said:
        return False, said
    certificate = subprocess.run(["gappa", "-Bcoq", *options, file.name], cwd=build,
                                 text=True, check=False, capture_output=True, timeout=LONGEST)
    if certificate.returncode:
        return False, certificate.stderr
    proved = HYPOTHESIS.sub(r"Lemma \1 : \2.\nProof. hint. Qed.", certificate.stdout)
    module = build / f"{file.stem}_certificate.v"
    module.write_text(HINTS + proved)
    status, more = run(["coqc", module.name], build)
    return status == 0 and not re.search(r"Hypothesis|Axiom|Admitted", proved), said + more


def portable(tree, build):
    """What Frama-C's preprocessor is told: the kernels' branches without intrinsics, and where
    <brink/...> is."""
    brink = build / "brink"
    if not brink.exists():
        brink.symlink_to(tree / "kernels")
    folders = f"-I{tree / 'kernels'} -I{tree / 'sim'} -I{build}"
    return f"-cpp-extra-args={folders} -U__SSE2__ -U__AVX__ -U__FMA__"


def wp(tree, build, file, options):
    """Every goal of Frama-C's WP, run-time errors among them; frama-c itself succeeds with
    goals open, so its summary is read.  What a file says is `transcribed` it includes: the
    formulas of other proofs, in ACSL."""
    for proof in re.findall(r"^// transcribed: (.*)$", file.read_text(), re.MULTILINE):
        header = build / f"{proof.replace('.', '_')}.h"
        run([sys.executable, TRANSCRIBE, tree / "proofs" / proof, header, "acsl"], build)
    provers = pathlib.Path(__file__).parent / "why3.conf"
    status, said = run(
        ["env", f"WHY3CONFIG={provers}", "frama-c", "-wp", "-wp-rte", "-wp-cache", "none",
         "-wp-smoke-tests", "-wp-smoke-timeout", "1", "-wp-no-smoke-dead-code",
         "-wp-par", "1", "-wp-prover", "cvc5-nofp,z3", "-wp-timeout", "120",
         "-warn-special-float", "none", portable(tree, build),
         *options, file], build)
    goals = re.findall(r"Proved goals: +(\d+) / (\d+)", said)
    if status or not goals or goals[-1][1] == "0":
        raise Unread(said)
    return goals[-1][0] == goals[-1][1], said


def eva(tree, build, file, options):
    """No alarm from Frama-C's Eva, and every assertion valid."""
    status, said = run(
        ["frama-c", "-eva", "-eva-precision", "6", "-warn-special-float", "none",
         portable(tree, build), *options, file], build)
    if status or "logical properties reached" not in said:
        raise Unread(said)
    whole = "0 alarms generated" in said and "100% of the logical properties" in said
    return whole, said


def cvc5(tree, build, file, options):
    """Unsatisfiable, bit by bit: there is no input that breaks the claim."""
    del tree
    status, said = run(["cvc5", "--fp-exp", *options, file], build)
    answers = set(said.split())
    if status or not answers or not answers <= {"sat", "unsat", "unknown"}:
        raise Unread(said)
    return answers == {"unsat"}, said


def small(tree, build, file, options):
    """A program that tries every input of a small format: the kernels' own source, included with
    other numbers in place of double (small_format.h), beside the same as it is compiled for the
    library (`with:`), which it must agree with at 53 bits.  Status 0: all hold; 1: one does not."""
    program = build / file.stem
    common = ["-O2", "-ffp-contract=off", f"-I{tree / 'kernels'}", f"-I{tree / 'proofs'}"]
    objects = []
    for source in options:
        objects.append(build / f"{pathlib.Path(source).stem}.o")
        status, said = run(["gcc", "-std=c17", *common, "-c", tree / source, "-o", objects[-1]],
                           build)
        if status:
            raise Unread(said)
    status, said = run(["g++", "-std=gnu++20", "-Wno-class-memaccess", *common, file, *objects,
                        "-o", program], build)
    if status:
        raise Unread(said)
    status, more = run([program], build)
    if status not in (0, 1):
        raise Unread(more)
    return status == 0, said + more


TOOLS = {"coq": coq, "gappa": gappa, "wp": wp, "eva": eva, "cvc5": cvc5, "small": small}
