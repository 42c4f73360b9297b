"""Runs that are set beside simulations and measurements of the source; `docs/make_validation.py` writes the page."""
