"""`scree fos` against limit equilibrium (tests/support/limit_analysis.py): factors, modes, and the answers where no
factor exists.

usage: fos_runs.py SCREE GROUP [WORK]     groups: quick, bolts, rock, jointed, modes, answers, resume, full (a table of every closed form by DDA and NMM, implicit and explicit steps)
"""

import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import fos_cases  # noqa: E402
import limit_analysis  # noqa: E402

SCREE = os.path.abspath(sys.argv[1])
failures = []
work = None


def expect(condition, text):
    print("  %s %s" % ("ok  " if condition else "FAIL", text), flush=True)
    if not condition:
        failures.append(text)


def written(name, text):
    folder = os.path.join(work, name)
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "case.toml")
    with open(path, "w") as f:
        f.write(text)
    return path


def fos(name, text, *options, code=0):
    """Answer of a search as JSON, with the processor time of all its processes."""
    path = written(name, text)
    before = os.times()
    run = subprocess.run([SCREE, "fos", path, "--out", os.path.join(work, name, "fos"), "--json", "-", "--quiet", *options], capture_output=True, text=True)
    after = os.times()
    if run.returncode != code:
        expect(False, "%s: exit code %d, wanted %d\n%s" % (name, run.returncode, code, run.stderr))
        return {"cpu": 0.0}
    answer = json.loads(run.stdout) if run.stdout.startswith("{") else {}
    answer["cpu"] = after.children_user + after.children_system - before.children_user - before.children_system
    return answer


def near(name, made, bound, *options, mode=None):
    text, reference = made
    a = fos(name, text, "--strength", "peak", *options)
    found = a.get("fos") or 0.0
    expect(abs(found - reference) <= bound * reference,
           "%-34s F %.4f, reference %.4f, %+.2f %% (%.1f %% allowed), %s, %d runs, %.1f s CPU" % (name, found, reference, 100 * (found / reference - 1), 100 * bound,
                                                                                         a.get("mode"), len(a.get("runs", [])), a["cpu"]))
    if mode:
        expect(a.get("mode") == mode, "%-34s %s, wanted %s" % (name, a.get("mode"), mode))
    return a


def quick():
    near("plane dry", fos_cases.plane_slope(), 0.01, mode="slides")
    near("plane with cohesion", fos_cases.plane_slope(phi=30.0, c=30e3), 0.01)
    near("plane, tension crack and water", fos_cases.plane_slope(phi=32.0, c=40e3, crack=5.0, water=4.0), 0.01)
    h = limit_analysis.culmann_height(20e3, 25.0, fos_cases.DENSITY * fos_cases.GRAVITY, 70.0)
    near("Culmann, three quarters of H_c", fos_cases.plane_slope(height=0.75 * h, face=70.0, dip=47.5, phi=25.0, c=20e3), 0.01)
    near("two wedges", fos_cases.two_wedges(), 0.01, mode="slides")
    near("block whose toe is excavated", fos_cases.excavated_toe(), 0.01, mode="slides")


# Closed forms of the table: name, case, method of the blocks beside the DDA, bound.
def closed_forms():
    h = limit_analysis.culmann_height(20e3, 25.0, fos_cases.DENSITY * fos_cases.GRAVITY, 70.0)
    c = fos_cases
    return [
        ("plane, dry", c.plane_slope, {}),
        ("plane, cohesion, tension crack", c.plane_slope, {"phi": 30.0, "c": 30e3, "crack": 5.0}),
        ("plane, tension crack and water", c.plane_slope, {"phi": 32.0, "c": 40e3, "crack": 5.0, "water": 4.0}),
        ("plane, cohesion, sharp tip", c.plane_slope, {"phi": 30.0, "c": 30e3}),
        ("Culmann, sharp tip", c.plane_slope, {"height": 0.75 * h, "face": 70.0, "dip": 47.5, "phi": 25.0, "c": 20e3}),
        ("two wedges", c.two_wedges, {}),
        ("anchored plane, pull 1 MN/m", lambda **k: c.anchored_plane(**k)[:2], {}),
        ("plane with a bar that yields", lambda **k: c.anchored_plane(active=False, **k)[:2], {}),
        ("columns of Goodman and Bray", c.published_columns, {}),
    ]


HOWS = (("dda", "implicit"), ("dda", "explicit"), ("nmm", "implicit"), ("nmm", "explicit"))


def closed_part(name):
    """Closed fraction of the joint's length at failure: an elastic tip lifts off, and an open joint has no cohesion."""
    import h5py

    answer = json.load(open(os.path.join(work, name, "fos", "result.json")))
    with h5py.File(os.path.join(work, name, "fos", "F-%.6g" % answer["fails"], "run.vtkhdf")) as f:
        first, count = (f["contacts/frames/" + k][-1] for k in ("first", "count"))
        share, state = (f["contacts/" + k][first : first + count] for k in ("share", "state"))
    return float(share[state != 0].sum() / share.sum())


def table(hows):
    """Every closed form by these methods and integrators, one row each; written to fos-table.md in the work folder, or
    where SCREE_FOS_TABLE says."""
    rows = []
    for method, integrator in hows:
        for title, make, keys in closed_forms():
            how = dict(keys, method=method, integrator=integrator)
            if method == "nmm":
                how["cover"] = 4.0
            made, name = make(**how), "%s %s: %s" % (method, integrator, title)
            a = fos(name, made[0], "--strength", "peak")
            found, reference, note, bound = a.get("fos") or 0.0, made[1], "", 0.01
            off = found / reference - 1.0
            wanted = "topples" if "Goodman" in title else "slides"
            if "Goodman" in title and method == "nmm":
                bound, note = 0.03, "covers 4 m, E 50 GPa"
            elif method == "nmm" and "sharp tip" in title:
                # F of friction alone plus F of cohesion, which is proportional to the closed length
                friction = math.tan(limit_analysis.rad(how["phi"])) / math.tan(limit_analysis.rad(how.get("dip", 35.0)))
                part = closed_part(name)
                closed = friction + (reference - friction) * part
                note = "%.1f %% of the joint are closed, by hand with these %.4f: %+.2f %%" % (100 * part, closed, 100 * (found / closed - 1))
                expect(abs(found / closed - 1.0) <= 0.01, name + ": " + note)
                bound = 0.03
            as_is, as_is_cpu = "", ""
            if "c" in keys:
                weak = fos(name + " as-is", made[0], "--strength", "as-is")
                as_is, as_is_cpu = "%.4f" % weak["fos"] if weak.get("fos") else str(weak.get("status")), "%.1f" % weak["cpu"]
                expect(0.0 < (weak.get("fos") or 0.0) <= 1.01 * reference, "%s: as-is %s, %s s CPU" % (name, as_is, as_is_cpu))
            expect(abs(off) <= bound and a.get("mode") == wanted, "%-48s F %.4f, by hand %.4f, %+.2f %%, %s, %.1f s CPU %s" % (name, found, reference, 100 * off, a.get("mode"),
                                                                                                                       a.get("cpu", 0.0), note))
            rows.append("| %s | %s %s | %.4f | %.4f | %.4f | %.1f | %s | %s | %s | %s |" % (title, method, integrator, reference, found, found / reference, a.get("cpu", 0.0), as_is, as_is_cpu,
                                                                                    a.get("mode"), note))
    head = "| slope | runs | F by hand | F found | ratio | CPU [s] | as-is | CPU [s] | mode | note |\n|---|---|---|---|---|---|---|---|---|---|\n"
    path = os.environ.get("SCREE_FOS_TABLE") or os.path.join(work, "fos-table.md")
    with open(path, "a") as f:
        f.write(head + "\n".join(rows) + "\n")
    print(head + "\n".join(rows))


def full():
    table(HOWS)
    made = fos_cases.published_columns(phi=38.15)  # tan 38.15 = 0.7855, with which the published slope just stands
    near("the published figure, F = 1", (made[0], 1.0), 0.03, mode="topples")


def bolts():
    near("anchored plane", fos_cases.anchored_plane()[:2], 0.01, mode="slides")
    near("plane with a bar that yields", fos_cases.anchored_plane(active=False)[:2], 0.01, mode="slides")
    near("columns of Goodman and Bray", fos_cases.published_columns(), 0.01, mode="topples")
    near("two wedges, explicit steps", fos_cases.two_wedges(integrator="explicit"), 0.01, mode="slides")


def answers():
    # below one: the slope fails with its actual strength
    near("weaker than it needs", fos_cases.plane_slope(phi=30.0), 0.01)
    # strength does not govern: a block that topples regardless of friction; it stands for k_h = tan(dip) - b/h
    text, _ = fos_cases.block_on_plane(1.0, 3.0, 30.0, 40.0)
    a = fos("topples whatever its friction", text, "--strength", "peak")
    expect(a.get("status") == "fails at the least factor", "no bracket: %s" % a.get("status"))
    k = (a.get("load_factor_k_h") or {}).get("stands")
    angle = limit_analysis.rad(30.0) - limit_analysis.math.atan(1.0 / 3.0)
    expect(k is not None and abs(abs(k) - limit_analysis.math.tan(angle)) <= 0.012 and k > 0.0, "load factor on k_h: %s, by hand %.4f" % (k, limit_analysis.math.tan(angle)))
    # stable at the largest factor: a block on level ground
    text, _ = fos_cases.block_on_plane(2.0, 1.0, 0.0, 30.0)
    a = fos("block on level ground", text, "--strength", "peak")
    expect(a.get("status") == "stable at the largest factor" and a.get("stands") == 10.0, "stable at F_max: %s" % a.get("status"))
    # undecided: on a flat plane, 8 degrees, a margin of 2 % accelerates less than 0.3 (1 - F_s) g, and the time is too
    # short to reach the displacement limit
    text, _ = fos_cases.block_on_plane(2.0, 1.0, 8.0, 20.0)
    a = fos("too little time", text, "--strength", "peak", "--time", "0.02", "--limit", "0.05", code=4)
    expect(a.get("status") == "undecided", "undecided: %s" % a.get("status"))
    # back-analysis: friction at which a slope just stands
    a = fos("back-analysis", fos_cases.plane_slope(phi=40.0)[0], "--strength", "peak", "--back-analysis", "phi")
    phi = a["joints"][0].get("at_limit", {}).get("friction_deg", 0.0)
    expect(abs(phi - 35.0) <= 0.2, "back-analysis: phi %.2f, by hand 35" % phi)
    # as-is: joints that lose cohesion point by point
    text, reference = fos_cases.plane_slope(phi=30.0, c=30e3)
    a = fos("as-is", text, "--strength", "as-is")
    expect(a.get("fos") and a["fos"] <= reference * 1.01, "as-is strength: F %s, peak %.4f" % (a.get("fos"), reference))


def rock():
    """Stress against the strength of the rock, computed by hand. A block of height h on smooth level ground has the
    mean stress s1 = 0, s3 = -rho g h/2 in the DDA."""
    text, _ = fos_cases.block_on_plane(4.0, 10.0, 0.0, 1e-3)
    s3 = fos_cases.DENSITY * fos_cases.GRAVITY * 5.0
    c, phi = 20e3, limit_analysis.rad(30.0)
    by_hand = 0.5 * s3 / (c * math.cos(phi) + 0.5 * s3 * math.sin(phi))
    a = fos("rock Mohr-Coulomb", text.replace("poisson = 0.2", "poisson = 0.2\nrock_strength = { cohesion = 20e3, friction_deg = 30.0 }"), "--strength", "peak")
    worst = (a.get("rock_at_rest") or [{}])[0]
    expect(worst.get("block") == "block" and abs(worst["utilisation"] / by_hand - 1.0) <= 1e-3, "Mohr-Coulomb: %s, by hand %.6f" % (worst.get("utilisation"), by_hand))
    expect(by_hand > 1.0 and abs(worst.get("area_above_m2", 0.0) - 40.0) <= 0.01, "all of the block is above it: %s m2" % worst.get("area_above_m2"))
    picture = os.path.join(work, "rock Mohr-Coulomb", "fos", "rock-strength.png")
    expect(os.path.exists(picture) and os.path.getsize(picture) > 10000, "rock-strength.png")
    # intact rock, m_i 10: 2 r = ucs sqrt(m (p - r)/ucs + 1), a quadratic for the radius r about p = s3/2
    ucs, m, p = 300e3, 10.0, 0.5 * s3
    r = (-m * ucs + math.sqrt((m * ucs) ** 2 + 16.0 * (m * ucs * p + ucs**2))) / 8.0
    a = fos("rock Hoek-Brown", text.replace("poisson = 0.2", "poisson = 0.2\nrock_strength = { ucs = 300e3, gsi = 100.0, mi = 10.0 }"), "--strength", "peak")
    worst = (a.get("rock_at_rest") or [{}])[0]
    expect(abs(worst.get("utilisation", 0.0) * r / p - 1.0) <= 1e-3, "Hoek and Brown: %s, by hand %.6f" % (worst.get("utilisation"), p / r))
    told = subprocess.run([SCREE, "report", os.path.join(work, "rock Mohr-Coulomb", "fos", "rest"), "--out", os.path.join(work, "report.html")], capture_output=True, text=True)
    expect(told.returncode == 0 and "stress is above the strength in 1 of 1 blocks" in open(os.path.join(work, "report.html")).read(), "the page of the run says so %s" % told.stderr)


def resume():
    text, _ = fos_cases.plane_slope(phi=30.0, c=30e3)
    whole = fos("whole", text, "--strength", "peak")
    path, out = written("killed", text), os.path.join(work, "killed", "fos")
    command = [SCREE, "fos", path, "--out", out, "--json", "-", "--quiet", "--strength", "peak"]
    for kills in range(3):
        p = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        time.sleep(0.35 + 0.5 * kills)
        os.killpg(p.pid, signal.SIGKILL)
        p.wait()
    last = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    whole.pop("cpu")
    last["case"] = whole["case"]
    expect(last == whole, "a search that was killed three times has the same answer, to the last figure")
    for name in ("stable.png", "failed.png", "fos.svg", "fos.csv", "result.json"):
        expect(os.path.getsize(os.path.join(out, name)) > 0, name)
    for factor in (whole["stands"], whole["fails"]):
        folder = os.path.join(out, "F-%.6g" % factor)
        expect(os.path.exists(os.path.join(folder, "run.xmf")) and os.path.exists(os.path.join(folder, "run.vtkhdf")), "run folder of F = %g" % factor)
    other = subprocess.run(command + ["--tolerance", "0.02"], capture_output=True, text=True)
    expect(other.returncode == 5 and "another search" in other.stderr and "--out" in other.stderr, "another question in the same folder is refused: %s" % other.stderr.strip())


def jointed():
    """A slope of 70 blocks with two joint sets, at default settings: found, in time, by a search that is killed half
    way; its two final runs open in ParaView."""
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "examples", "jointed-slope.toml")
    out = os.path.join(work, "jointed")
    command = [SCREE, "fos", path, "--out", out, "--strength", "peak", "--json", "-", "--quiet"]
    p = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    begun = time.monotonic()
    while time.monotonic() - begun < 120 and not os.path.exists(os.path.join(out, "F-2.2", "summary.json")):
        time.sleep(0.1)
    os.killpg(p.pid, signal.SIGKILL)
    p.wait()
    done = {d: os.stat(os.path.join(out, d, "summary.json")).st_mtime for d in os.listdir(out) if os.path.exists(os.path.join(out, d, "summary.json"))}
    before = os.times()
    a = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    after, wall = os.times(), time.monotonic() - begun
    cpu = after.children_user + after.children_system - before.children_user - before.children_system
    print("  70 blocks, killed half way: F %.4f, %d runs, %.1f s of processor time after the kill, %.1f s in all on the clock" % (a.get("fos") or 0.0, len(a["runs"]), cpu, wall))
    expect(a["status"] == "found" and a["fails"] - a["stands"] <= 0.01 + 1e-9, "70 blocks: %s between %s and %s" % (a["status"], a.get("stands"), a.get("fails")))
    expect(cpu <= 60.0, "the search takes less than 60 s of processor time: %.1f" % cpu)
    expect(done and all(os.stat(os.path.join(out, d, "summary.json")).st_mtime == t for d, t in done.items()), "%d runs that had ended are not made again" % len(done))
    pvpython = shutil.which("pvpython")
    for key, picture in (("stands", "stable.png"), ("fails", "failed.png")):
        folder = os.path.join(out, "F-%.6g" % a[key])
        expect(os.path.getsize(os.path.join(out, picture)) > 10000, picture)
        if pvpython:
            told = subprocess.run([pvpython, os.path.join(os.path.dirname(os.path.abspath(__file__)), "check_paraview.py"), folder, "--one-mesh"], capture_output=True, text=True).stdout
            expect("paraview: all readers fine" in told, "ParaView opens F-%.6g: %s" % (a[key], told.strip()))


def modes():
    """Ten cases whose mode is known."""

    def mode(name, text, wanted, *options):
        a = fos(name, text, "--strength", "peak", "--tolerance", "0.05", *options)
        expect(a.get("mode") == wanted, "%-44s %s, wanted %s (F %s, %s)" % (name, a.get("mode"), wanted, a.get("fos"), a.get("status")))

    c = fos_cases
    mode("block on a plane", c.block_on_plane(4.0, 2.0, 30.0, 40.0)[0], "slides")
    mode("wedge behind a face, with cohesion", c.plane_slope(phi=30.0, c=30e3)[0], "slides")
    mode("two wedges on a broken plane", c.two_wedges()[0], "slides")
    mode("block on a plane under k_h", c.block_on_plane(4.0, 2.0, 20.0, 40.0)[0], "slides", "--kh", "-0.1")
    mode("slender block on a steep plane", c.block_on_plane(1.0, 3.0, 30.0, 40.0)[0], "topples")
    mode("slender block under k_h", c.block_on_plane(1.0, 3.0, 10.0, 40.0)[0], "topples", "--kh", "-0.3")
    mode("columns on a stepped base", c.columns([2.0, 4.0, 6.0, 4.0], 2.0, 2.6, 2.4, 0.6, 25.0, 42.0, 3)[0], "topples")
    mode("block under a roof", c.hanging_block()[0], "falls")
    ledge = [(-6.0, -1.0), (0.0, -1.0), (0.0, 6.0), (-3.0, 6.0), (-3.0, 0.0), (-6.0, 0.0)]
    law = {"friction_deg": 30.0, "cohesion": 30e3, "tensile_strength": 30e3}
    mode("block bonded to a wall above the ground", c.case("block on a wall", ledge, [("block", [(0.0, 3.0), (0.4, 3.0), (0.4, 6.0), (0.0, 6.0)])], {"bond": law}), "slides")
    mode("prop that carries nothing any more", c.case("block between walls", [(-5, -6), (5, -6), (5, 4), (1, 4), (2, 0), (2, -5), (-2, -5), (-2, 0), (-1, 4), (-5, 4)],
                                                        [("block", [(-1.75, 1.0), (1.75, 1.0), (1.25, 3.0), (-1.25, 3.0)])], {"wall": {"friction_deg": 40.0}}), "falls")


if __name__ == "__main__":
    work = sys.argv[3] if len(sys.argv) > 3 else tempfile.mkdtemp(prefix="scree-fos-")
    limit_analysis.check()
    for group in sys.argv[2].split(","):
        {"quick": quick, "full": full, "bolts": bolts, "rock": rock, "jointed": jointed, "answers": answers, "resume": resume, "modes": modes}[group]()
    if len(sys.argv) <= 3:
        shutil.rmtree(work)
    if failures:
        sys.exit("%d failed" % len(failures))
