"""Small mistakes in C++, which is searched as text: clang-format has put a space around each operator.

What is no longer C++ afterwards is left to the compiler.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

# Comments, text, lines of the preprocessor, what a compiler checks, errors, types and the lengths of arrays.
PASSED_OVER = re.compile(
    r"""//.*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^\\'\n])'|^\#.*"""
    r"""|\b(?:static_assert|throw|using|namespace)\b[^;{]*|\btemplate <[^>]*>|\b(?:array|get|span)<[^;(){}]*?>""",
    re.MULTILINE,
)
NUMBER = re.compile(r"(?<![\w.'])\d[\d']*(?:\.\d*)?(?:e[+-]?\d+)?(?![\w.'])")
OPERATORS = {
    "<": ("<=", ">"), "<=": ("<", ">"), ">": (">=", "<"), ">=": (">", "<"), "==": ("!=",), "!=": ("==",),
    "+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "+=": ("-=",), "-=": ("+=",), "*=": ("/=",), "/=": ("*=",),
    "&&": ("||",), "||": ("&&",),
}  # fmt: skip
OPERATOR = re.compile(rf"(?<= )(?:{'|'.join(map(re.escape, OPERATORS))})(?=\s)")
WORDS = {
    "min": "max", "max": "min", "any_of": "all_of", "all_of": "any_of", "true": "false", "false": "true",
    "break": "continue", "continue": "break", "std::fabs": "", "std::sqrt": "",
}  # fmt: skip
WORD = re.compile(rf"(?<![\w.])(?:{'|'.join(WORDS)})\b|(?<=std::)(?:min|max|any_of|all_of)\b(?=\()")
SIGN = re.compile(r"(?:(?<=[(\[{!])|(?<=[=,?:<>*/&|] )|(?<=return ))[-!](?=[\w(])")
CONDITION = re.compile(r"(?<=if \()[\w.:>\[\]]+(?=\))")
PLACE = r"(?!return|delete)[\w.:>()\[\]-]+"
STATEMENT = re.compile(
    rf"(?<=[;{{}})]\n)[ ]+(?:(?:else )?(?:if|for) \(.*\) )?({PLACE}(?: [-+*/]?= .*|\(.*\)|);)$", re.MULTILINE
)
WORDS_BEFORE, WORDS_AFTER = re.compile(r"(?:\S+ ){0,2}\S*$"), re.compile(r"\S*(?: \S+)?")
HEAD = re.compile(r"^(?!namespace|using|template)[a-zA-Z].*", re.MULTILINE)
NAME = re.compile(r"(?:struct|class|enum class) (\w+)|^[^=]*?([\w:~]+)\(")


def changes(text: str) -> Iterator[tuple[str, int, int, str]]:
    """Yield the function or type that each change is in, its first and last offset, and what is put there."""
    code = PASSED_OVER.sub(lambda match: " " * len(match[0]), text)
    heads = [(match.start(), NAME.search(match[0])) for match in HEAD.finditer(code)]
    changed = [(*match.span(), after) for match in NUMBER.finditer(code) for after in _others(match[0])]
    changed += [(*match.span(), after) for match in OPERATOR.finditer(code) for after in OPERATORS[match[0]]]
    changed += [(*match.span(), WORDS[match[0]]) for match in WORD.finditer(code)]
    changed += [(*match.span(), "") for match in SIGN.finditer(code)]
    changed += [(*match.span(), f"!{match[0]}") for match in CONDITION.finditer(code)]
    changed += [(*match.span(1), ";") for match in STATEMENT.finditer(code)]
    for start, end, after in sorted(changed):
        name = [name for at, name in heads if at <= start][-1:]
        line = text.rfind("\n", 0, start) + 1
        # With two words before it and one after, or one "<" could hardly be told from another.
        before, behind = WORDS_BEFORE.search(text[line:start]), WORDS_AFTER.match(text, end)
        words = (before[0], behind[0]) if after != ";" and before and behind else ("", "")
        function = next((each[1] or each[2] for each in name if each), "")
        yield function, start - len(words[0]), end + len(words[1]), f"{words[0]}{after}{words[1]}"


def _others(number: str) -> list[str]:
    plain = number.replace("'", "")
    if plain.isdigit():
        return [str(int(plain) + 1), *([str(int(plain) - 1)] if int(plain) else [])]
    value = float(plain)
    return [repr(2.0 * value), repr(0.5 * value)] if value else ["1.0"]
