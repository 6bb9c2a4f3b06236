"""A dent in the raceway under a roller, as a hard particle leaves it: where the pressure goes.

A roller 20 x 20 with a logarithmic profile on an inner ring of 80 mm, 20 kN. The dent, 0.5 mm wide and 3 micrometres
deep within a shoulder of 0.4 micrometres, lies where the roller passes it at this moment. Strips cannot see
it: its relief changes across the contact. So both cases are solved on a plane grid. That pressures at the rim of a
dent shorten the life of a bearing is what methods for arbitrary contacts were first wanted for (de Mul, Vree and
Kuijpers 1987). Prints a table and writes out/dented-raceway.svg.

    python examples/dented-raceway.py
"""

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.patch import Dent, PatchSolution
from nonhertz.plot.style import COLOUR_MAP, FIRST, INK, LINE, SECOND, sheet_style

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.iso_logarithmic(diameter=20, length=20))
CONTACT = nh.Contact(ROLLER, nh.Ring(diameter=80))
DENT = Dent(x=0.0, y=3.0, depth=0.003, diameter=0.5, shoulder=0.0004, shoulder_diameter=1.0)
LOAD = 20e3  # N
CELLS = (64, 1536)
SHOWN = (1.5, 4.5)  # mm along


def solve(*features: Dent) -> PatchSolution:
    """Return the contact with the features."""
    return nh.patch.solve(CONTACT, load=LOAD, features=features, cells=CELLS)


def draw(smooth: PatchSolution, dented: PatchSolution, path: Path) -> None:
    """Write the map of the pressure around the dent, and a cut through it either way."""
    with sheet_style():
        figure = Figure(figsize=(6.7, 4.6), layout="constrained")
        (upper, lower) = figure.subfigures(2, 1, height_ratios=(0.8, 1.0))
        area = upper.add_subplot()
        _draw_map(dented, area)
        along, across = lower.subplots(1, 2, sharey=True, width_ratios=(3.0, 2.0))
        for solution, name, colour, dashes in ((smooth, "smooth", SECOND, "--"), (dented, "dented", FIRST, "-")):
            style = {"label": name, "color": colour, "linestyle": dashes, "linewidth": LINE}
            along.plot(solution.y, solution.centre_pressure, **style)
            across.plot(*solution.across(DENT.y), **style)
        along.set(xlabel="$y$ [mm]", ylabel="Pressure $p$ [MPa]", xlim=SHOWN, ylim=(0.0, 1.1 * dented.max_pressure))
        along.set_title("Along the centre line", loc="left")
        across.set(xlabel="$x$ [mm]")
        across.set_title(f"Across, at $y$ = {DENT.y:g} mm", loc="left")
        along.legend(loc="lower left")
        for axes in (along, across):
            axes.spines[["top", "right"]].set_visible(False)
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, metadata={"Date": None})


def _draw_map(dented: PatchSolution, area) -> None:
    """Draw the pressure in true proportions, with the edge of the footprint and the rim of the dent."""
    pressing = np.where(dented.footprint, dented.pressure, np.nan)
    field = area.pcolormesh(dented.y, dented.x, pressing, cmap=COLOUR_MAP, vmin=0.0, shading="nearest", rasterized=True)
    area.contour(dented.y, dented.x, dented.footprint.astype(float), levels=[0.5], colors=INK, linewidths=0.7)
    around = np.linspace(0.0, 2.0 * np.pi, 200)
    radius = 0.5 * DENT.diameter
    area.plot(
        DENT.y + radius * np.cos(around), DENT.x + radius * np.sin(around), color="white", linestyle=":", linewidth=0.9
    )
    area.set(xlabel="$y$ [mm]", ylabel="$x$ [mm]", xlim=SHOWN, aspect="equal")
    area.set_title("Pressure around the dent (dotted: its rim)", loc="left")
    area.figure.colorbar(field, ax=area, label="Pressure $p$ [MPa]", shrink=0.8)


def main(out: Path = Path("out")) -> dict[str, PatchSolution]:
    """Print the table, write the figure, return both solutions."""
    smooth, dented = solve(), solve(DENT)
    print(f"{'':28}{'smooth':>12}{'dented':>12}")
    rows = {
        "maximum pressure [MPa]": [f"{s.max_pressure:.0f}" for s in (smooth, dented)],
        "  at x, y [mm]": [f"{s.max_pressure_x:.2f}, {s.max_pressure_y:.2f}" for s in (smooth, dented)],
        "contact area [mm^2]": [f"{s.contact_area:.3f}" for s in (smooth, dented)],
        "approach [um]": [f"{1e3 * s.approach:.3f}" for s in (smooth, dented)],
    }
    for name, (left, right) in rows.items():
        print(f"{name:28}{left:>12}{right:>12}")
    print(f"The dent raises the maximum by {100.0 * (dented.max_pressure / smooth.max_pressure - 1.0):.0f} %.")
    draw(smooth, dented, out / "dented-raceway.svg")
    return {"smooth": smooth, "dented": dented}


if __name__ == "__main__":
    main()
