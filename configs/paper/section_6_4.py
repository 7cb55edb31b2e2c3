"""Table and picture of docs/low_capillary.md from folders of studies of section 6.4:

    section_6_4.py FOLDER...                  the table
    section_6_4.py --picture FILE FOLDER      1280 elements, as the paper's figure 18 e to g

Each row is a case.  Wrinkles are what a smooth motion leaves: the part of the positions along the normal that
no polynomial of degree 6 in the positions at rest explains, as root mean square over the nodes, in radii."""

import csv
import glob
import itertools
import sys

import h5py
import numpy as np

DEGREE = 6
POWERS = [p for p in itertools.product(range(DEGREE + 1), repeat=3) if sum(p) <= DEGREE and p[2] <= 1]


class State:
    """A snapshot."""

    def __init__(self, path):
        with h5py.File(path) as file:
            grid = file["VTKHDF"]
            self.t = float(grid["FieldData/TimeValue"][0])
            self.elements = grid["Connectivity"][:].reshape(-1, 6)
            fields = {name: grid["PointData/" + name][:] for name in ("X", "x", "T2", "d")}
        self.X, self.x, self.T2, self.d = (fields[name] for name in ("X", "x", "T2", "d"))

    def triangles(self):
        """Corners of four flat triangles in each element: [4 elements][3]."""
        parts = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
        return np.concatenate([self.elements[:, part] for part in parts])

    def compressed_share(self):
        """Share of the area where the smaller principal tension is negative."""
        corners = self.triangles()
        a, b, c = (self.x[corners[:, k]] for k in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        return area[self.T2[corners].mean(axis=1) < 0].sum() / area.sum()

    def off_smooth(self):
        """Along the normal, at the nodes."""
        basis = np.stack([np.prod(self.X**p, axis=1) for p in np.array(POWERS)], axis=1)
        smooth = basis @ np.linalg.lstsq(basis, self.x, rcond=None)[0]
        normal = self.x / np.linalg.norm(self.x, axis=1)[:, None]
        return np.einsum("ij,ij->i", self.x - smooth, normal)

    def wrinkles(self):
        return np.sqrt(np.mean(self.off_smooth() ** 2))


def angle_to_vorticity(X):
    return np.degrees(np.arccos(np.clip(abs(X[1]) / np.linalg.norm(X), 0, 1)))


def states(case):
    return [State(path) for path in sorted(glob.glob(case + "/snapshot_*.vtkhdf"))]


def at(all_states, t):
    return min(all_states, key=lambda state: abs(state.t - t))


def number(text):
    return float(text) if text else float("nan")


def pair(first, second, form="%.2f"):
    return form % first + ", " + (form % second if second == second else "-")


def value_at(history, column, t):
    """Not a number beyond the end of the run."""
    return np.interp(t, history["t"], history[column], right=float("nan"))


def row(folder, entry):
    case = folder + "/cases/" + entry["case"]
    all_states = states(case)
    Ca = float(entry["flow.capillary_number"])
    history = np.genfromtxt(case + "/history.csv", delimiter=",", names=True)
    t_c, t_l = number(entry["t_c"]), number(entry["t_l"])
    early, late = at(all_states, 0.25), at(all_states, LATE)
    first = next((state for state in all_states if state.d.max() > 0), None)
    to_major_axis = number(entry["angle_to_major_axis_deg"])
    rupture_X = np.array([number(entry["rupture_X_%d" % k]) for k in (1, 2, 3)])
    return [
        "%d" % (20 * 4 ** int(entry["capsule.mesh.subdivisions"])),
        "%g" % Ca,
        pair(*(value_at(history, "D12", t) / Ca for t in (10 * Ca, LATE)), "%.3f"),
        pair(*(value_at(history, "Y_max", t) / Ca**2 for t in (20 * Ca, LATE))),
        pair(early.wrinkles(), late.wrinkles(), "%.1e"),
        pair(early.compressed_share(), late.compressed_share()),
        "%.3f" % t_c if t_c == t_c else "none",
        "%.0f" % angle_to_vorticity(first.X[np.argmax(first.d)]) if first else "-",
        "%.2f" % t_l if t_l == t_l else "none",
        pair(angle_to_vorticity(rupture_X), to_major_axis, "%.0f") if t_l == t_l else "-",
        "%.2f" % number(entry["t"]),
        "%.2f" % (number(entry["L1"]) / 2),
    ]


LATE = 2.0
HEADER = ["elements", "Ca", "D12/Ca at 10 Ca, 2", "Y/Ca^2 at 20 Ca, 2", "wrinkles at 0.25, 2",
          "T2 < 0 at 0.25, 2", "t_c", "first damage", "t_l", "rupture", "end", "L1/2"]


def print_table(folders):
    print("| " + " | ".join(HEADER) + " |\n" + "|---" * len(HEADER) + "|")
    for folder in folders:
        with open(folder + "/table.csv") as file:
            for entry in csv.DictReader(file):
                if entry["t"]:
                    print("| " + " | ".join(row(folder, entry)) + " |")


def draw(axes, state, value, limits, colours, title):
    """The capsule seen against the vorticity axis, from a little above the shear plane."""
    import matplotlib.pyplot as plt
    from matplotlib.collections import PolyCollection

    up = np.radians(35)
    view = np.array([0, -np.cos(up), np.sin(up)])
    right = np.array([1.0, 0, 0])
    top = np.cross(right, view)
    corners = state.x[state.triangles()]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    front = normal @ view > 0
    flat = np.stack([corners[front] @ right, corners[front] @ top], axis=2)
    depth = (corners[front].mean(axis=1) @ view).argsort()
    faces = PolyCollection(flat[depth], cmap=colours, edgecolors="face", linewidths=0.2)
    faces.set_array(value[state.triangles()].mean(axis=1)[front][depth])
    faces.set_clim(*limits)
    axes.add_collection(faces)
    axes.set(xlim=(-1.3, 1.3), ylim=(-1.2, 1.2), aspect="equal", title=title)
    axes.axis("off")
    plt.colorbar(faces, ax=axes, shrink=0.7)


def picture(path, folder):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    with open(folder + "/table.csv") as file:
        cases = {e["case"]: e for e in csv.DictReader(file)}
    entry = [cases["subdivisions=3,capillary_number=0.0" + Ca] for Ca in ("05", "10", "12")]
    shown = [states(folder + "/cases/" + e["case"]) for e in entry]
    wrinkled, torn = shown[0][-1], shown[2][-1]
    ruptured = next(s for s in shown[1] if s.t >= float(entry[1]["t_l"]))
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.4), layout="constrained")
    draw(axes[0], wrinkled, 1e3 * wrinkled.off_smooth(), (-5, 5), "PuOr",
         "Ca = 0.005, t = %.2f: wrinkles, 1e-3 a" % wrinkled.t)
    draw(axes[1], ruptured, ruptured.d, (0, 1), "viridis", "Ca = 0.010, t = %.2f: damage" % ruptured.t)
    draw(axes[2], torn, torn.d, (0, 1), "viridis", "Ca = 0.012, t = %.2f: damage" % torn.t)
    figure.savefig(path, dpi=110)


if sys.argv[1] == "--picture":
    picture(*sys.argv[2:])
else:
    print_table(sys.argv[1:])
