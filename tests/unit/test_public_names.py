"""The names at the top of the package: all there, documented, and free until asked for."""

import pytest

import nonhertz as nh


def test_every_public_name_resolves():
    assert all(getattr(nh, name) is not None for name in dir(nh))


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'sovle'"):
        _ = nh.sovle
