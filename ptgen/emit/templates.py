"""The only door to the templates, and the only module that knows where they are."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import jinja2

import ptgen

__all__ = ["render"]


def render(name: str, **context: object) -> str:
    """Fill in the template `name`.

    Raises
    ------
    jinja2.UndefinedError
        If the template uses something that `context` does not have.
    """
    return _environment().get_template(name).render(version=ptgen.__version__, template=name, **context)


@lru_cache(maxsize=1)
def _environment() -> jinja2.Environment:
    package = Path(ptgen.__file__).parent
    folders = [folder for folder in (package / "_templates", package.parent / "templates") if folder.is_dir()]
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(folders),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
