#!/usr/bin/python3
"""Counts instructions, to show that a body pays for nothing that its scene does not ask for.

Usage: test_instructions.py [PROBE]    The last line reads "N passed, M failed".

A free body that is moved as its scene says must execute what Stepper::advance, called in a loop by hand, executes, within
1 %; rk4 also what the loop over its inline step executes. An effect on one body must leave the counts of the others as
they were. That the comparisons can fail is shown by counts with 2 % more steps, and with an absent torque evaluated.
The counts are valgrind's, exact, and do not depend on how busy the machine is.
"""
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "test"))
from checks import check, finish  # noqa: E402
PROBE = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "devel", "lib", "poinsot", "instruction_probe")
METHODS = ("lie_euler buss2 buss3 buss4 rk4 rkmk4 cf4 midpoint splitting2 splitting4 splitting6 dmv2 dmv4 dmv6 dmv8 "
           "dmv10").split()
STEP = 2.0 ** -10  # s: no step is cut by rounding
STEPS = 4096
STATES = 120
FREE = "inertia: [1, 2, 3], angular_velocity: [0.4, 1, 0.2]"
PLACES = {"in_closed_form": "[-20, 0, 0]", "stepped": "[20, 0, 0]", "changed": "[0, 0, 0]"}
EFFECTS = {
    "translation": "velocity: [0, 0, 1]",
    "constant_torque": "frame: world, torque: [0, 0, 0.1]",
    "gravity_torque": "mass: 1, centre_of_mass: [0, 0, 0.1]",
    "gravity_gradient": "orbit_rate: 0.1, orbit_normal: [0, 0, 1], radial_at_start: [1, 0, 0]",
    "viscous_damping": "coefficient: 0.1",
    "internal_dissipation": "slug_inertia: 0.1, damping: 0.1",
    "torque_schedule": "segments: [{from: 0.5, to: 1, frame: body, torque: [0, 0, 0.1]}]",
}
SAME = 0.01         # relative: what "the same number" means for a free scene
UNCHANGED = 0.0001  # and for bodies beside one that has an effect
COMPOSED = 0.10     # a state in closed form against one composed by hand



def counts(folder, *words):
    """Runs the probe; {name: instructions}."""
    out = os.path.join(folder, "callgrind.out")
    # Symbols are bound at the start, not when a count first meets them; valgrind does not know every vector instruction.
    said = subprocess.run(["valgrind", "--tool=callgrind", "--collect-atstart=no", "--combine-dumps=yes",
                           "--callgrind-out-file=" + out, PROBE] + [str(word) for word in words],
                          env=dict(os.environ, LD_BIND_NOW="1", POINSOT_SIMD="baseline"),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if said.returncode != 0:
        sys.exit("the probe failed:\n%s\n0 passed, 1 failed" % said.stdout[-3000:])
    with open(out) as handle:
        text = handle.read()
    os.remove(out)
    return {name: int(total) for name, total in
            re.findall(r"^desc: Trigger: Client Request: (\S+)\n(?:.*\n)*?totals: (\d+)$", text, re.MULTILINE)}


def write(folder, name, bodies):
    path = os.path.join(folder, name + ".yaml")
    with open(path, "w") as handle:
        handle.write("bodies:\n" + "".join("  - {%s}\n" % body for body in bodies))
    return path


def differences(found, one, other, tolerance):
    """Complaints about each pair of counts that differ; one and other are ends of names."""
    out = []
    pairs = [(name, name[:-len(one)] + other) for name in found if name.endswith(one) and name[:-len(one)] + other in found]
    for a, b in pairs:
        if abs(found[a] / found[b] - 1) > tolerance:
            out.append("%s executes %d instructions, %s %d: %+.2f %%" %
                       (a, found[a], b, found[b], 100 * (found[a] / found[b] - 1)))
    return out if pairs else ["nothing to compare"]


def misquoted(document, state):
    """Complaints where the document's sentence on a state in closed form has other counts; 1 % stands for other compilers."""
    sentence = re.search(r"in closed form executes (\d+) instructions, one composed by hand .*? (\d+)[;,.].*? (\d+) of them are the "
                         r"closed form itself", document, re.DOTALL)
    if not sentence:
        return ["expected \"in closed form executes N instructions, one composed by hand … N; … N of them are the closed form "
                "itself\""]
    return ["expected %.0f, got %s" % (count, quoted) for count, quoted in zip(state, sentence.groups())
            if abs(int(quoted) / count - 1) > 0.01]


def changes(found, effect):
    """Complaints about the bodies beside one that has the effect, against the scene without it."""
    return [complaint for body in ("in_closed_form", "stepped")
            for complaint in differences({name: found[name] for name in ("%s/%s" % (effect, body), "free/" + body)},
                                         "%s/%s" % (effect, body), "free/" + body, UNCHANGED)]


def bodies_with(effect):
    """Three bodies, the last of which has the effect beside its place, or another place if none is given."""
    out = []
    for name, place in PLACES.items():
        words = "name: %s, %s" % (name, FREE)
        words += "" if name == "in_closed_form" else ", method: %s, step: %.17g" % ("dmv8" if name == "stepped" else "rk4", STEP)
        effects = [] if name == "changed" else ["{type: translation, position: %s}" % place]
        if name == "changed" and effect:
            effects.append("{type: %s, %s}" % (effect, EFFECTS[effect]))
        out.append(words + ", effects: [%s]" % ", ".join(effects) if effects else words)
    return out


def main():
    with tempfile.TemporaryDirectory() as folder:
        scene = write(folder, "free", ["name: closed_form, " + FREE] + [
            "name: %s, method: %s, step: %.17g, %s" % (method, method, STEP, FREE) for method in METHODS])
        found = counts(folder, "free", scene, STEPS)
        missing = [m for m in METHODS if m + "/scene" not in found or m + "/stepper" not in found]
        check("every method is counted", ["no %s" % m for m in missing])
        check("a free body of a scene executes what its stepper does, called by hand",
              differences(found, "/scene", "/stepper", SAME))
        check("under rk4 also what a loop over the inline step does",
              differences({n: c for n, c in found.items() if n.startswith("rk4/")}, "/scene", "/by_hand", SAME))
        check("a state in closed form executes little more than one composed by hand",
              differences({n: c for n, c in found.items() if n.startswith("closed_form/")}, "/scene", "/by_hand", COMPOSED))
        for method in METHODS:
            print("        %-10s %8.1f instructions a step, by hand %8.1f" %
                  (method, found[method + "/scene"] / STEPS, found[method + "/stepper"] / STEPS))
        state = [found["closed_form/" + way] / STEPS for way in ("scene", "by_hand", "closed_form_alone")]
        print("        closed_form %7.1f instructions a state, composed by hand %.1f, without E, L and omega %.1f" % tuple(state))
        with open(os.path.join(ROOT, "doc", "scene_cost.md")) as handle:
            document = handle.read()
        check("doc/scene_cost.md has the counts of a state in closed form", misquoted(document, state))
        more_by_a_tenth = [1.1 * count for count in state]
        check("and an old count in it would be noticed", [] if misquoted(document, more_by_a_tenth) else ["it is not"])

        scenes = [write(folder, "free", bodies_with(None))] + [write(folder, e, bodies_with(e)) for e in EFFECTS]
        found_beside = counts(folder, "others", STATES, *scenes)
        for effect in EFFECTS:
            check("%s on one body leaves the others as they were" % effect, changes(found_beside, effect))
        check("and is paid for by the one that has it",
              ["%s: nothing" % e for e in EFFECTS if not found_beside[e + "/changed"] > found_beside["free/changed"]])

        # The comparisons above can fail.
        for extra in ("2_percent", "absent_torque"):
            noticed = differences(found, "/stepper_and_" + extra, "/stepper", SAME)
            check("work on the free path would be noticed: %s more" % extra.replace("_", " "),
                  [] if len(noticed) == len(METHODS) else ["only for %d of %d methods" % (len(noticed), len(METHODS))])
        more = dict(found_beside, **{"translation/stepped": int(1.001 * found_beside["translation/stepped"])})
        check("work on another body would be noticed", [] if len(changes(more, "translation")) == 1 else ["it is not"])
    return finish()


if __name__ == "__main__":
    sys.exit(main())
