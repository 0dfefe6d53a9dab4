"""What help() shows, and the version."""

import inspect
import re
from pathlib import Path

import pytest

import surface_mesh_cutting as smc

KINDS = {"unwrap": smc.CuttingOptions, "greedy_cut": smc.CuttingOptions, "detect_feature_points": smc.CuttingOptions,
         "connect_points": smc.ConnectionOptions, "cut_handles": smc.ConstraintOptions, "pack_charts": smc.SurfaceOptions,
         "certify_unwrap": smc.SurfaceOptions, "steiner_tree": smc.RunOptions}


def test_all_functions_are_here():
    assert set(KINDS) == {name for name in smc.__all__ if inspect.isfunction(getattr(smc, name))}


@pytest.mark.parametrize("name, kind", KINDS.items())
def test_docstrings_list_all_options(name, kind):
    """Each once, with an explanation that is indented below it, in front of what is returned."""
    text = inspect.getdoc(getattr(smc, name))
    arguments = text[:text.index("\nReturns\n")]
    options = [*kind.__annotations__, *(parameter.name for parameter in inspect.signature(getattr(smc, name)).parameters.values()
                                        if parameter.kind is parameter.KEYWORD_ONLY)]
    for option in options:
        assert len(re.findall(rf"^(?:[a-z_]+, )*{option}\b[^\n]*\n    \S", arguments, re.MULTILINE)) == 1, option
    assert "**options" not in text


def test_version():
    text = (Path(__file__).parents[2] / "CMakeLists.txt").read_text(encoding="utf-8")
    assert f"project(Surface_mesh_cutting VERSION {smc.__version__} " in text
