"""Errors of functions with the commands that do the same in their remedies."""

#: Remedies of functions, and those of the command line for a file.
_COMMANDS = {
    "nonhertz.MATERIALS lists all": "'nonhertz materials' lists all",
    "use nonhertz.read_case": "use 'nonhertz solve {}'",
    "use nonhertz.read_bearing": "use 'nonhertz bearing {}'",
    "use nonhertz.read_plan": "use 'nonhertz sweep {}'",
    "begin with one from nonhertz.new_case": "begin with one from 'nonhertz new {}'",
    "begin with one from nonhertz.new_bearing": "begin with one from 'nonhertz new --bearing {}'",
    "write one that names its case": "begin with one from 'nonhertz new --plan {}'",
    "write a plan, and": "begin with one from 'nonhertz new --plan', and",
}


def name_commands(sentence: str) -> str:
    """Return a sentence about a file, with commands in place of functions.

    Examples
    --------
    >>> name_commands("six.toml must hold a single contact, not a bearing: use nonhertz.read_bearing.")
    "six.toml must hold a single contact, not a bearing: use 'nonhertz bearing six.toml'."
    """
    path = sentence.partition(" must ")[0]
    for function, command in _COMMANDS.items():
        sentence = sentence.replace(function, command.format(path))
    return sentence
