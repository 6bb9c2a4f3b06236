"""Words of a figure, and whether they can be read."""

import itertools

from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox


def words(figure: Figure) -> list[str]:
    return [text.get_text() for text in figure.findobj(Text) if text.get_text()]


def placed(figure: Figure) -> list[tuple[str, Bbox]]:
    """Return every text that shows ink, with its box in pixels, ticks beyond the axes' limits left out."""
    figure.draw_without_rendering()
    hidden = set()
    for axis in (axis for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)):
        low, high = sorted(axis.get_view_interval())
        slack = 1e-9 * (high - low)
        for tick in axis.get_major_ticks():
            if not low - slack <= tick.get_loc() <= high + slack:
                hidden |= {tick.label1, tick.label2}
    texts = [text for text in figure.findobj(Text) if text.get_text() and text.get_visible() and text not in hidden]
    return [(text.get_text(), Text.get_window_extent(text)) for text in texts]


def can_be_read(figure: Figure) -> None:
    """Fail where words overlap or leave the paper."""
    boxes = placed(figure)
    for text, box in boxes:
        assert 0.0 <= box.x0 <= box.x1 <= figure.bbox.x1, text
        assert 0.0 <= box.y0 <= box.y1 <= figure.bbox.y1, text
    for (text, box), (other, its) in itertools.combinations(boxes, 2):
        assert not box.overlaps(its), (text, other)
