"""The compiler's setting is ours while we compile, and everybody else's again afterwards."""

import numba
import numpy as np
import pytest

from nonhertz.compiled import compiled


def seen_while_compiling(monkeypatch, function):
    """Return the setting that the compiler meets while it compiles ``function``."""
    seen = []
    plain = numba.core.codegen.CPUCodegen._function_pass_manager

    def watched(codegen, **options):
        seen.append(numba.core.config.SLP_VECTORIZE)
        return plain(codegen, **options)

    monkeypatch.setattr(numba.core.codegen.CPUCodegen, "_function_pass_manager", watched)
    function()
    return set(seen)


def test_operations_are_gathered_in_our_functions_alone(monkeypatch, tmp_path):
    # What an earlier run has kept would not be compiled.
    monkeypatch.setattr(numba.core.config, "CACHE_DIR", str(tmp_path))
    before = numba.core.config.SLP_VECTORIZE
    ours, theirs = compiled(lambda x: x + 1.0), numba.njit(lambda x: x + 2.0)
    assert seen_while_compiling(monkeypatch, lambda: ours(1.0)) == {1}
    assert before == numba.core.config.SLP_VECTORIZE
    assert seen_while_compiling(monkeypatch, lambda: theirs(1.0)) == {before}


def test_the_setting_comes_back_after_a_failure():
    before = numba.core.config.SLP_VECTORIZE
    hopeless = compiled(lambda x: x.nowhere)
    with pytest.raises(numba.core.errors.TypingError):
        hopeless(np.ones(3))
    assert before == numba.core.config.SLP_VECTORIZE
