"""One self-contained HTML file with everything about a case, or a comparison of several, for all who lack the program.

`compose` makes it from cases. In steps: `settled` solves them, `examined` adds stress below the surface and life,
`rendered` writes the page. The file loads nothing from elsewhere and contains no script and no date: the same cases on
the same machine give the same bytes.

Whole bearings have reports of the same kind, with what is their own in `nonhertz.report.bearing`: `compose` takes
either, and in steps these are `settled_bearings` and `rendered`.

How it is made: modules here turn results into rows and sentences (`inputs`, `assumptions`, `method`, `differences`),
figures into inline SVG (`drawing`), and files into links that contain them (`downloads`). The page is a list of
sections (`page`), which the templates and their style sheet only lay out.
"""

from nonhertz.files.title_block import TitleBlock as TitleBlock
from nonhertz.report.bearing.results import BearingResults as BearingResults
from nonhertz.report.bearing.results import settled_bearings as settled_bearings
from nonhertz.report.layout import MARK as MARK
from nonhertz.report.page import compose as compose
from nonhertz.report.page import rendered as rendered
from nonhertz.report.results import CaseResults as CaseResults
from nonhertz.report.results import examined as examined
from nonhertz.report.results import settled as settled
from nonhertz.report.results import steps as steps
