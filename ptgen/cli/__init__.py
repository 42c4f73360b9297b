"""The command line: ``ptgen check|show|derive|modal|gears|generate|build|simulate|schema``."""

from ptgen.cli.application import app, main

__all__ = ["app", "main"]
