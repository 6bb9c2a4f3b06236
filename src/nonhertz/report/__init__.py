"""One HTML file that tells everything of a case, or of several side by side, to people who run nothing.

`compose` makes it of cases. In steps: `settled` solves them, `examined` adds stress below the
surface and life, `rendered` writes the page. The file loads nothing from elsewhere and holds no script and no date: the
same cases on the same machine give the same bytes.

How it is made: modules here turn results into rows and sentences (`inputs`, `assumptions`, `method`, `differences`),
figures into SVG that can stand in a page (`drawing`), files into links that hold them (`downloads`). The templates and
their style sheet lay them out and know no numbers.
"""

from nonhertz.report.page import MARK as MARK
from nonhertz.report.page import compose as compose
from nonhertz.report.page import rendered as rendered
from nonhertz.report.results import CaseResults as CaseResults
from nonhertz.report.results import examined as examined
from nonhertz.report.results import settled as settled
from nonhertz.report.results import steps as steps
