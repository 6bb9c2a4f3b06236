"""Small mistakes in the sources, one at a time: which there can be, and a list of them that stays the same.

Every mutant changes one expression or leaves out one statement. Python is parsed, C++ searched as text. Which are
chosen is decided by a hash of what they change and where, so that an edit of one function leaves the rest of the list
as it is.
"""

from __future__ import annotations

import ast
import hashlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import cpp

COMPARISONS = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
}
OPERATIONS = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.Pow: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.MatMult: None,
}
CALLS = {"min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum", "any": "all", "all": "any"}
DROPPED_CALLS = {"abs", "sqrt", "cumsum", "sort", "copy"}


@dataclass(frozen=True)
class Mutant:
    """One mistake: the text between two offsets of a file replaced by another.

    Attributes
    ----------
    path : str
        File, below the sources.
    function : str
        The function or class it is in, with those around it; empty for a module's own constants.
    start, end : int
        Offsets in the text; not part of the key.
    before, after : str
        What stood there, and what does now.
    ordinal : int
        Which of several with the same words in the same function.
    """

    path: str
    function: str
    start: int
    end: int
    before: str
    after: str
    ordinal: int = 1

    @property
    def key(self) -> str:
        """What it is known by when lines move."""
        numbered = f" ({self.ordinal})" if self.ordinal > 1 else ""
        return f"{self.path} {self.function or '-'}: {self.before} -> {self.after}{numbered}"

    def applied(self, text: str) -> str:
        """Return the text of the file with the mistake in it."""
        return text[: self.start] + self.after + text[self.end :]


def mutants(path: Path, name: str) -> list[Mutant]:
    """Return all mutants of a file; those of Python still are Python, of those of C++ most are C++."""
    text = path.read_text(encoding="utf-8")
    found = _Finder(text).found if path.suffix == ".py" else cpp.changes(text)
    seen: Counter[str] = Counter()
    numbered = []
    for function, start, end, after in found:
        each = Mutant(name, function, start, end, " ".join(text[start:end].split()), after)
        seen[each.key] += 1
        numbered.append(replace(each, ordinal=seen[each.key]))
    return numbered


def ranked(of_room: list[Mutant], seed: int) -> list[Mutant]:
    """Return the mutants of one room in the order in which they are tried."""
    return sorted(of_room, key=lambda each: hashlib.sha256(f"{seed} {each.key}".encode()).digest())


class _Finder(ast.NodeVisitor):
    def __init__(self, text: str) -> None:
        self.text = text
        self.found: list[tuple[str, int, int, str]] = []
        self._lines = [0]
        for line in text.splitlines(keepends=True):
            self._lines.append(self._lines[-1] + len(line))
        self._within: list[str] = []
        self.visit(ast.parse(text))

    def _offset(self, line: int, column: int) -> int:
        """Return the offset in characters; Python counts columns in bytes."""
        start = self._lines[line - 1]
        text = self.text[start : self._lines[line]]
        return start + len(text.encode()[:column].decode())

    def _add(self, node: ast.expr | ast.stmt, after: str) -> None:
        start = self._offset(node.lineno, node.col_offset)
        end = self._offset(node.end_lineno or node.lineno, node.end_col_offset or 0)
        if " ".join(self.text[start:end].split()) != after:
            self.found.append((".".join(self._within), start, end, after))

    def _replace(self, node: ast.expr, changed: ast.expr) -> None:
        self._add(node, f"({ast.unparse(changed)})")

    # Where to look

    def _visit_body(self, node: ast.FunctionDef | ast.ClassDef) -> None:
        self._within.append(node.name)
        of_function = isinstance(node, ast.FunctionDef)
        defaults = [*node.args.defaults, *filter(None, node.args.kw_defaults)] if of_function else []
        for each in (*defaults, *node.body):
            self.visit(each)
        self._within.pop()

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        self._visit_body(node)

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        self._visit_body(node)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.visit(node.value)

    def visit_Assert(self, node: ast.Assert) -> None:
        """Pass over what is there for the type checker."""

    def visit_Raise(self, node: ast.Raise) -> None:
        """Pass over the words of errors."""

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        """Pass over text."""

    def visit_keyword(self, node: ast.keyword) -> None:
        """Pass over what makes sure that there are as many of both, where there are."""
        if node.arg != "strict":
            self.visit(node.value)

    # Expressions

    def visit_Constant(self, node: ast.Constant) -> None:
        for after in other_numbers(node.value):
            self._add(node, after)

    def visit_Compare(self, node: ast.Compare) -> None:
        for k, operator in enumerate(node.ops):
            for other in COMPARISONS.get(type(operator), ()):
                ops = [*node.ops[:k], other(), *node.ops[k + 1 :]]
                self._replace(node, ast.Compare(node.left, ops, node.comparators))
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        other = OPERATIONS.get(type(node.op))
        if other is not None and not _is_text(node.left) and not _is_type(node):
            self._replace(node, ast.BinOp(node.left, other(), node.right))
        self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> None:
        self._replace(node, ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values))
        self.generic_visit(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> None:
        if isinstance(node.op, ast.USub | ast.Not):
            self._replace(node, node.operand)
        self.generic_visit(node)

    def visit_IfExp(self, node: ast.IfExp) -> None:
        self._replace(node, ast.IfExp(ast.UnaryOp(ast.Not(), node.test), node.body, node.orelse))
        self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> None:
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name in CALLS:
            self._replace(node, ast.Call(_renamed(node.func, CALLS[name]), node.args, node.keywords))
        elif name in DROPPED_CALLS and len(node.args) == 1:
            self._replace(node, node.args[0])
        self.generic_visit(node)

    # Statements

    def visit_If(self, node: ast.If) -> None:
        if ast.unparse(node.test) == "TYPE_CHECKING":
            return
        self._replace(node.test, ast.UnaryOp(ast.Not(), node.test))
        self.generic_visit(node)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        self._add(node, "pass")
        self.visit(node.value)

    def visit_Assign(self, node: ast.Assign) -> None:
        if self._within and all(isinstance(each, ast.Subscript | ast.Attribute) for each in node.targets):
            self._add(node, "pass")
        self.generic_visit(node)

    def visit_Expr(self, node: ast.Expr) -> None:
        if isinstance(node.value, ast.Constant):
            return
        self._add(node, "pass")
        self.generic_visit(node)

    def visit_Continue(self, node: ast.Continue) -> None:
        self._add(node, "break")

    def visit_Break(self, node: ast.Break) -> None:
        self._add(node, "continue")


def other_numbers(value: object) -> Iterator[str]:
    """Yield what a number or truth value is replaced by."""
    if isinstance(value, bool):
        yield str(not value)
    elif isinstance(value, int):
        yield str(value + 1)
        if value > 0:
            yield str(value - 1)
    elif isinstance(value, float):
        yield repr(2.0 * value if value else 1.0)
        if value:
            yield repr(0.5 * value)


def _renamed(function: ast.expr, name: str) -> ast.expr:
    return ast.Attribute(function.value, name) if isinstance(function, ast.Attribute) else ast.Name(name)


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def _is_type(node: ast.BinOp) -> bool:
    return isinstance(node.op, ast.BitOr)
