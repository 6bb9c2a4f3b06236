"""Small mistakes in the sources, one at a time: which there can be, and a list of them that stays the same.

Every mutant changes one expression or leaves out one statement. Which are chosen is decided by a hash of what they
change and where, so that an edit of one function leaves the rest of the list as it is.
"""

from __future__ import annotations

import ast
import hashlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

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
COMPILING = ("compiled", "inlined")
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
    line : int
        Where, counted from 1; not part of the key.
    start, end : int
        Offsets in the text.
    before, after : str
        What stood there, and what does now.
    ordinal : int
        Which of several with the same words in the same function.
    compiled : bool
        Whether machine code changes by it.
    last : int
        Line on which the expression ends.
    statement : int
        Line on which the statement begins.
    names : tuple of str
        What runs when it does, where its own lines say nothing of that: a compiled function, whose lines no tracer
        sees, a class, a constant; empty in other functions.
    """

    path: str
    function: str
    line: int
    start: int
    end: int
    before: str
    after: str
    compiled: bool
    last: int
    statement: int
    names: tuple[str, ...]
    ordinal: int = 1

    @property
    def key(self) -> str:
        """What it is known by when lines move."""
        numbered = f" ({self.ordinal})" if self.ordinal > 1 else ""
        return f"{self.path} {self.function or '-'}: {self.before} -> {self.after}{numbered}"

    def applied(self, text: str) -> str:
        """Return the text of the file with the mistake in it; all other lines keep their numbers."""
        lost = "\n" * text.count("\n", self.start, self.end)
        after = f"{self.after[:-1]}{lost})" if lost and self.after.endswith(")") else self.after + lost
        return text[: self.start] + after + text[self.end :]


def mutants(path: Path, name: str) -> list[Mutant]:
    """Return all mutants of a file, each of which still is Python."""
    text = path.read_text(encoding="utf-8")
    found = _Finder(text, name).found
    seen: Counter[str] = Counter()
    numbered = []
    for each in found:
        seen[each.key] += 1
        numbered.append(replace(each, ordinal=seen[each.key]))
    return numbered


def chosen(of_group: list[Mutant], count: int, seed: int) -> list[Mutant]:
    """Return so many of the mutants of one group, in the order of their files."""
    ranked = sorted(of_group, key=lambda each: hashlib.sha256(f"{seed} {each.key}".encode()).digest())
    return sorted(ranked[:count], key=lambda each: (each.path, each.start, each.after))


def assigned(statement: ast.AST) -> tuple[str, ...]:
    """Return the names that a statement gives values."""
    return tuple(
        each.id for each in ast.walk(statement) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
    )


def is_compiled(node: ast.AST) -> bool:
    """Return whether this is a function that is compiled, or what it makes is, of which no line is seen to run."""
    return isinstance(node, ast.FunctionDef) and any(
        isinstance(each, ast.Name) and each.id in COMPILING for each in ast.walk(node)
    )


class _Finder(ast.NodeVisitor):
    def __init__(self, text: str, name: str) -> None:
        self.text, self.name = text, name
        self.found: list[Mutant] = []
        self._lines = [0]
        for line in text.splitlines(keepends=True):
            self._lines.append(self._lines[-1] + len(line))
        self._within: list[str] = []
        self._compiled, self._runs = "", False
        self._statement: ast.stmt = ast.Pass(lineno=0)
        tree = ast.parse(text)
        # A constant of the module may be compiled into any function.
        self._module_compiled = any(f"@{each}" in text for each in COMPILING)
        self.visit(tree)

    def _offset(self, line: int, column: int) -> int:
        """Return the offset in characters; Python counts columns in bytes."""
        start = self._lines[line - 1]
        text = self.text[start : self._lines[line]]
        return start + len(text.encode()[:column].decode())

    def _add(self, node: ast.expr | ast.stmt, after: str) -> None:
        start = self._offset(node.lineno, node.col_offset)
        end = self._offset(node.end_lineno or node.lineno, node.end_col_offset or 0)
        before = " ".join(self.text[start:end].split())
        if before == after:
            return
        compiled = bool(self._compiled) if self._within else self._module_compiled
        last = node.end_lineno or node.lineno
        self.found.append(
            Mutant(
                self.name, ".".join(self._within), node.lineno, start, end, before, after, compiled,
                last, self._statement.lineno, () if self._runs and not compiled else self._known_as(),
            )
        )  # fmt: skip

    def _known_as(self) -> tuple[str, ...]:
        """Return the names by which others use what is being read."""
        return (self._compiled or self._within[-1],) if self._within else assigned(self._statement)

    def _replace(self, node: ast.expr, changed: ast.expr) -> None:
        self._add(node, f"({ast.unparse(changed)})")

    # Where to look

    def visit(self, node: ast.AST) -> None:
        """Remember the statement."""
        outer = self._statement
        self._statement = node if isinstance(node, ast.stmt) else outer
        super().visit(node)
        self._statement = outer

    def _visit_body(self, node: ast.FunctionDef | ast.ClassDef) -> None:
        outer, ran = self._compiled, self._runs
        self._compiled = outer or (node.name if is_compiled(node) else "")
        self._within.append(node.name)
        defaults = [*node.args.defaults, *filter(None, node.args.kw_defaults)] if _is_function(node) else []
        for each in defaults:
            self.visit(each)
        self._runs = _is_function(node)
        for each in node.body:
            self.visit(each)
        self._within.pop()
        self._compiled, self._runs = outer, ran

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
        for after in _other_numbers(node.value):
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


def _other_numbers(value: object) -> Iterator[str]:
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


def _is_function(node: ast.AST) -> bool:
    return isinstance(node, ast.FunctionDef)
