"""Docstrings, ``__all__`` and doctests of every module."""

from __future__ import annotations

import doctest
import importlib
import inspect
from pathlib import Path
from types import ModuleType

import pytest

PACKAGE = Path(__file__).resolve().parents[2] / "ptgen"


def dotted(file: Path) -> str:
    return ".".join(file.relative_to(PACKAGE.parent).with_suffix("").parts).removesuffix(".__init__")


# Importing ``__main__`` would start the program, and an empty package file has nothing to say.
MODULES = [
    dotted(file)
    for file in sorted(PACKAGE.rglob("*.py"))
    if file.name != "__main__.py" and file.read_text(encoding="utf-8").strip()
]


@pytest.fixture(params=MODULES)
def module(request: pytest.FixtureRequest) -> ModuleType:
    return importlib.import_module(request.param)


def public(module: ModuleType) -> dict[str, object]:
    """Return the public classes and functions that a module defines itself."""
    return {
        name: value
        for name, value in vars(module).items()
        if not name.startswith("_")
        and (inspect.isclass(value) or inspect.isfunction(value))
        and value.__module__ == module.__name__
    }


def test_there_are_modules() -> None:
    assert {"ptgen.elements", "ptgen.mechanism.assembly", "ptgen.control.lie"} <= set(MODULES)


def test_everything_public_is_documented(module: ModuleType) -> None:
    assert (module.__doc__ or "").strip(), "the module says what it is for"
    missing = []
    for name, value in public(module).items():
        if not (inspect.getdoc(value) or "").strip():
            missing.append(name)
        if not inspect.isclass(value):
            continue
        for key, member in vars(value).items():
            function = getattr(member, "__func__", getattr(member, "fget", getattr(member, "func", member)))
            if key.startswith("_") or not inspect.isfunction(function):
                continue
            if not (inspect.getdoc(getattr(value, key)) or function.__doc__ or "").strip():
                missing.append(f"{name}.{key}")
    assert not missing


def order(name: str) -> tuple[int, str]:
    """Constants, then classes, then the rest, as the linter sorts them."""
    return (0 if name.isupper() else 1 if name[0].isupper() else 2, name)


def test_all_is_complete_and_sorted(module: ModuleType) -> None:
    defined = public(module)
    exported = getattr(module, "__all__", None)
    if exported is None:
        assert not defined, "give the module an __all__"
        return
    assert list(exported) == sorted(set(exported), key=order)
    assert all(hasattr(module, name) for name in exported)
    assert set(defined) <= set(exported), "public, but not in __all__: begin its name with _, or export it"


def test_doctests_run(module: ModuleType) -> None:
    results = doctest.testmod(module)
    assert results.failed == 0


def test_there_are_doctests() -> None:
    finder = doctest.DocTestFinder(exclude_empty=True)
    examples = sum(len(test.examples) for name in MODULES for test in finder.find(importlib.import_module(name)))
    assert examples > 10
