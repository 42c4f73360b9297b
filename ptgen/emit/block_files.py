"""Blocks as C files: their own, and the support code that they need."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ptgen.block.block import Block
from ptgen.block.kernels import TAYLOR_DEGREE
from ptgen.emit.c_block import CBlock
from ptgen.emit.c_expressions import Precision, literal
from ptgen.emit.fluid_source import uses_fluid
from ptgen.emit.friction_source import uses_friction
from ptgen.emit.governor_source import uses_governor
from ptgen.emit.templates import render
from ptgen.friction.box import DEFICIENT, ROUNDING

__all__ = ["block_files", "common_context"]

_FAILURE_TEXTS = {
    "mass_matrix": "the inertia matrix is not positive definite",
    "exponential_range": "the parameters are too far from those that the code was emitted for; emit it again",
    "friction_matrix": "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter",
}


def common_context(prefix: str, bed_file: str, digest: str, precision: Precision) -> dict[str, object]:
    """Return what every template of a bed may use."""
    suffix = "f" if precision == "float" else ""
    return {
        "prefix": prefix,
        "bed_file": bed_file,
        "digest": digest,
        "precision": precision,
        "zero": literal(0.0, precision),
        "one": literal(1.0, precision),
        "half": literal(0.5, precision),
        "taylor_degree": TAYLOR_DEGREE,
        "deficient_limit": DEFICIENT,
        "rounding": ROUNDING,
        **{function: f"{function}{suffix}" for function in ("sqrt", "floor", "exp", "sin", "fabs")},
    }


def block_files(
    blocks: Sequence[Block],
    context: Mapping[str, object],
    variants: Mapping[str, Mapping[str, Mapping[str, float]]] | None = None,
) -> dict[str, str]:
    """Return the C files of blocks that belong together, by name.

    Parameters
    ----------
    blocks : sequence of Block
        One of them the plant, if there is one.
    context : mapping
        What `common_context` returns.
    variants : mapping, optional
        Parameter sets besides the defaults: block, name of the set, parameter -> value.
    """
    prefix = str(context["prefix"])
    precision: Precision = "float" if context["precision"] == "float" else "double"
    orders = [block.declared("A").shape[1] for block in blocks if block.signal("A") is not None]
    common = {**context, "max_order": max(orders, default=1), "failure_texts": _FAILURE_TEXTS}
    files = {f"{prefix}_support.{suffix}": render(f"support.{suffix}.jinja", **common) for suffix in ("h", "c")}
    for block in blocks:
        friction, governor, fluid = uses_friction(block), uses_governor(block, precision), uses_fluid(block)
        if fluid is not None:
            files[f"{prefix}_fluid.h"] = render("fluid.h.jinja", **common, **fluid)
        for suffix in ("h", "c"):
            if friction is not None:
                files[f"{prefix}_friction.{suffix}"] = render(f"friction.{suffix}.jinja", **common, **friction)
            if governor is not None:
                files[f"{prefix}_governor.{suffix}"] = render(f"governor.{suffix}.jinja", **common, **governor)
            sets = {
                name: {parameter: literal(value, precision) for parameter, value in values.items()}
                for name, values in (variants or {}).get(block.name, {}).items()
            }
            text = render(f"block.{suffix}.jinja", block=CBlock(block, prefix, precision), variants=sets, **common)
            files[f"{prefix}_{block.name}.{suffix}"] = text
    return files
