"""The life of a raceway with a dent that is rolled over, against the depth of the dent and the height of its shoulder.

A roller 20 x 8 with a strong crown on an inner ring of 80 mm, 300 N: a contact of 0.3 x 1.6 mm under 1140 MPa. The
dents are 0.3 mm wide, and each lies once on every 10 mm^2 of the raceway. Prints the life with each over that of the
smooth raceway and writes out/overrolled-dent.svg for the last of them. Takes a minute or two.

    python examples/overrolled-dent.py
"""

from pathlib import Path

import nonhertz as nh
from nonhertz.life import Overrolled
from nonhertz.plot import dent_figure, save

ROLLER = nh.Roller(diameter=20, length=8, profile=nh.profile.crown(radius=100))
CONTACT = nh.Contact(ROLLER, nh.Ring(diameter=80))
LOAD = 300  # N
DENTS = [
    nh.patch.Dent(depth=depth, diameter=0.3, shoulder=shoulder)
    for depth, shoulder in ((0.001, 0.0), (0.002, 0.0), (0.002, 0.00025), (0.002, 0.0005))
]
MODELS = [nh.life.model(name) for name in ("lundberg-palmgren", "zaretsky", "weibull")]


def main(out: Path = Path("out"), cell: float | None = None) -> list[Overrolled]:
    """Print the table, write the figure, return the dents that were rolled over."""
    solution = nh.solve(CONTACT, load=LOAD)
    print(f"{'depth':>7}{'shoulder':>10}{'pressure':>10}" + "".join(f"{each.name:>19}" for each in MODELS))
    found = []
    for dent in DENTS:
        found.append(nh.life.overrolled(solution, dent, body="b", cell=cell))
        numbers = f"{1e3 * dent.depth:4.1f} um{1e3 * dent.shoulder:7.2f} um{found[-1].max_pressure.max():6.0f} MPa"
        print(numbers + "".join(f"{found[-1].relative_life(each, per_area=0.1):19.3f}" for each in MODELS))
    out.mkdir(parents=True, exist_ok=True)
    save(dent_figure(found[-1], MODELS[1]), out / "overrolled-dent")
    return found


if __name__ == "__main__":
    main()
