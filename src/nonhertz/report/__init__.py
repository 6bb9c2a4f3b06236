"""One self-contained HTML file with everything about a case, or several side by side, for readers without the program.

`compose` makes it from cases. In steps: `settled` solves them, `examined` adds stress below the surface and life,
`rendered` writes the page. The file loads nothing from elsewhere and contains no script and no date: the same cases on
the same machine give the same bytes.

How it is made: modules here turn results into rows and sentences (`inputs`, `assumptions`, `method`, `differences`),
figures into inline SVG (`drawing`), and files into links that contain them (`downloads`). The templates and their style
sheet only lay them out.
"""

from nonhertz.report.page import MARK as MARK
from nonhertz.report.page import compose as compose
from nonhertz.report.page import rendered as rendered
from nonhertz.report.results import CaseResults as CaseResults
from nonhertz.report.results import examined as examined
from nonhertz.report.results import settled as settled
from nonhertz.report.results import steps as steps
