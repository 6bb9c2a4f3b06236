"""One self-contained HTML file with everything about a case, or a comparison of several, readable without the program.

`compose` makes it from cases, of contacts or of bearings. In steps: `solve_all` solves them, `post_process` adds stress
below the surface, life and slices, `to_html` writes the page. The file loads nothing from elsewhere and contains no
script; without a date, the same cases on the same machine give the same bytes.

A page is a list of sections (`page`). The sections of results are the same as in a terminal (`nonhertz.show`), with
figures between them; the others state the basis of the results (`inputs`, `assumptions`, `method`), or show several
results side by side (`differences`). The templates and their style sheet only lay out tables, sentences, figures as
images that contain their SVG, and files as links that contain them (`downloads`).
"""

from nonhertz.files.title_block import TitleBlock as TitleBlock
from nonhertz.report.layout import MARK as MARK
from nonhertz.report.page import compose as compose
from nonhertz.report.page import to_html as to_html
from nonhertz.report.results import BearingResults as BearingResults
from nonhertz.report.results import CaseResults as CaseResults
from nonhertz.report.results import count_steps as count_steps
from nonhertz.report.results import post_process as post_process
from nonhertz.report.results import solve_all as solve_all
