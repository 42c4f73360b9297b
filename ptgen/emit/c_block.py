"""A block as C: fields of its structs, and the lines of its sections."""

from __future__ import annotations

import itertools
import textwrap
from dataclasses import dataclass

import sympy as sp
from sympy.logic.boolalg import Boolean

from ptgen.block.block import Assign, Block, Call, Section, Signal, Statement, Table, parse_element
from ptgen.emit.c_expressions import CExpressions, Precision, literal
from ptgen.emit.fluid_source import uses_fluid
from ptgen.emit.friction_source import uses_friction
from ptgen.emit.governor_source import GOVERNORS, uses_governor

__all__ = ["BAD_INPUT", "CBlock", "CField", "CInput", "CTable", "padded"]

_FAILURES = {
    "cholesky_solve": "mass_matrix",
    "discretise": "exponential_range",
    "require_definite": "friction_matrix",
}


_WIDTH = 112


@dataclass(frozen=True)
class CField:
    """A field of a struct: its declaration and its comment."""

    name: str
    dimensions: str
    comment: str
    initial: str


BAD_INPUT = 1100
"""Status of a block whose first input is refused; further inputs follow."""


@dataclass(frozen=True)
class CInput:
    """An input of a step: the condition under which it is refused, true for NaN, and what is said of it then."""

    name: str
    status: int
    refused: str
    said: str


@dataclass(frozen=True)
class CTable:
    """A constant array: its declaration, its comment, and the lines of its initialiser, one column after the other."""

    name: str
    dimensions: str
    comment: list[str]
    lines: list[str]


def _wrapped(line: str) -> list[str]:
    """Break a long statement between its tokens."""
    return textwrap.wrap(line, _WIDTH, subsequent_indent="    ", break_long_words=False) or [line]


def _chain(expression: sp.Expr) -> list[tuple[sp.Expr, Boolean]]:
    """Return values and the conditions under which the next one is taken, of what `ControllerWriter.latch` writes."""
    chain: list[tuple[sp.Expr, Boolean]] = []
    while isinstance(expression, sp.Piecewise) and len(expression.args) == 2 and expression.args[1][0].is_Number:
        (following, condition), (value, _) = expression.args
        chain.append((value, condition))
        expression = following
    return [*chain, (expression, sp.true)]


def padded(count: int) -> int:
    """Round up to a multiple of four: arrays are padded so that loops run over four rows at a time."""
    return (count + 3) // 4 * 4


class CBlock:
    """What the templates need of a block.

    Matrices are stored by columns, ``M[column][row]``, with rows padded to a multiple of four, so that a product with a
    vector runs down contiguous memory.

    Parameters
    ----------
    block : Block
    prefix : str
        Name of the bed.
    precision : {"double", "float"}
    """

    def __init__(self, block: Block, prefix: str, precision: Precision) -> None:
        self.block = block
        self.prefix = prefix
        self.name = f"{prefix}_{block.name}"
        self.precision: Precision = precision
        self.description = block.description
        self.parameters = [self._field(signal) for signal in block.parameters]
        self.inputs = [self._field(signal) for signal in block.inputs]
        self.outputs = [self._field(signal) for signal in block.outputs]
        self.states = [self._field(signal) for signal in block.states]
        self.derived = [self._field(signal) for signal in block.derived]
        self.faults = block.faults
        self.alarms = block.alarms
        self.tracked = block.tracked
        self.slow = [item for item in block.tracked if not item.quick]
        self.quick = [item for item in block.tracked if item.quick]
        self.has_refresh = bool(block.refresh)
        self.tables = [self._table(table) for table in block.tables]
        self.has_measure = bool(block.measure)

    # -- declarations

    def _field(self, signal: Signal) -> CField:
        value = literal(signal.value, self.precision)
        unit = f"{signal.description} ({signal.unit})" if signal.unit else signal.description
        if signal.entries:
            unit += ":"
        return CField(signal.name, self._dimensions(signal.shape), unit, value)

    def _table(self, table: Table) -> CTable:
        comment = f"{table.description} ({table.unit})" if table.unit else table.description
        if table.entries:
            comment += ": " + ", ".join(table.entries)
        array = table.array()
        columns = [array] if array.ndim == 1 else array.T
        lines: list[str] = []
        for column in columns:
            numbers = ", ".join(literal(value, self.precision) for value in column)
            lines += _wrapped(f"{{ {numbers} }}," if array.ndim == 2 else f"{numbers},")
        dimensions = self._dimensions(table.shape)
        return CTable(table.name, dimensions, textwrap.wrap(comment, _WIDTH), lines)

    @property
    def has_friction(self) -> bool:
        """Whether the block solves for friction or contact torques."""
        return uses_friction(self.block) is not None

    @property
    def has_fluid(self) -> bool:
        """Whether the block computes torques of a fluid."""
        return uses_fluid(self.block) is not None

    @property
    def has_governor(self) -> bool:
        """Whether the block shapes references."""
        return uses_governor(self.block, self.precision) is not None

    def entry_comments(self, name: str) -> list[str]:
        """Return the meaning of each entry of an array, for the header."""
        signal = self.block.signal(name)
        return [f"[{i}] {entry}" for i, entry in enumerate(signal.entries)] if signal else []

    @staticmethod
    def _dimensions(shape: tuple[int, ...]) -> str:
        if not shape:
            return ""
        if len(shape) == 1:
            return f"[{padded(shape[0])}]"
        return f"[{shape[1]}][{padded(shape[0])}]"

    def initial_states(self) -> list[tuple[str, str]]:
        """Return the states that do not start at zero."""
        return [
            (signal.name, literal(signal.value, self.precision))
            for signal in self.block.states
            if signal.value != 0 and not signal.shape
        ]

    def parameter_limits(self) -> list[dict[str, str]]:
        """Return the range of each parameter: lower and upper bound, and whether the lower one, or zero, is out."""
        rows = []
        for signal in self.block.parameters:
            rows.append(
                {
                    "name": signal.name,
                    "least": f"-{self._largest}" if signal.least is None else literal(signal.least, self.precision),
                    "most": self._largest if signal.most is None else literal(signal.most, self.precision),
                    "open": "0" if signal.least_allowed or signal.least is None else "1",
                    "not_zero": "1" if signal.least is None and not signal.least_allowed else "0",
                }
            )
        return rows

    def input_limits(self) -> list[CInput]:
        """Return what each input is held against; blocks with supervision judge their inputs themselves."""
        if self.faults:
            return []
        return [
            CInput(signal.name, BAD_INPUT + index, self._refused(signal), self._wanted(signal))
            for index, signal in enumerate(self.block.inputs)
        ]

    def _refused(self, signal: Signal) -> str:
        value, parts = f"in->{signal.name}", []
        if signal.least is not None:
            parts.append(f"{value} {'>=' if signal.least_allowed else '>'} {literal(signal.least, self.precision)}")
        if signal.most is not None:
            parts.append(f"{value} <= {literal(signal.most, self.precision)}")
        if len(parts) < 2:
            parts.append(f"{self.prefix}_is_finite({value})")
        return f"!({' && '.join(parts)})" if len(parts) > 1 else f"!{parts[0]}"

    @staticmethod
    def _wanted(signal: Signal) -> str:
        match signal.least, signal.most:
            case None, None:
                return "is not finite"
            case least, None:
                return f"is outside its range from {least:g}"
            case None, most:
                return f"is outside its range to {most:g}"
            case least, most:
                return f"is outside its range {least:g} to {most:g}"

    @property
    def _largest(self) -> str:
        return "FLT_MAX" if self.precision == "float" else "DBL_MAX"

    def failures(self) -> list[str]:
        """Return the names of the ways in which preparation can fail."""
        used = {statement.kernel for statement in self.block.prepare if isinstance(statement, Call)}
        return [name for kernel, name in _FAILURES.items() if kernel in used]

    # -- statements

    def lines(self, section: Section) -> list[str]:
        """Return the body of a section, without indentation."""
        statements = self.block.statements(section)
        result = [f"{self.prefix}_real {name}{dimensions};" for name, dimensions in self._arrays(section)]
        result += [f"{self.prefix}_zero(sizeof {name}, {name});" for name, _ in self._arrays(section)]
        if result:
            result.append("")
        declared: set[str] = set()
        printer = CExpressions(self.prefix, self.precision, self._place)
        source = ""
        for condition, group in itertools.groupby(statements, key=lambda s: getattr(s, "condition", None)):
            margin = ""
            if condition is not None:
                result.append(f"if ({printer.doprint(condition)}) {{")
                margin = "    "
            for statement in group:
                if statement.source and statement.source != source:
                    result.append(f"{margin}/* {statement.source} */")
                source = statement.source or source
                result += [
                    margin + part for line in self._statement(statement, printer, declared) for part in _wrapped(line)
                ]
            if condition is not None:
                result.append("}")
        return result

    def _arrays(self, section: Section) -> list[tuple[str, str]]:
        used: set[str] = set()
        for statement in self.block.statements(section):
            if isinstance(statement, Assign):
                names = [statement.target, *(symbol.name for symbol in statement.free_symbols)]
            else:
                names = [*statement.outputs, *statement.inputs]
            used |= {parse_element(name)[0] for name in names}
        return [(s.name, self._dimensions(s.shape)) for s in self.block.arrays if s.name in used]

    def uses(self, section: Section, kind: str) -> bool:
        """Return whether a section touches the struct of `kind`."""
        names = {signal.name for signal in getattr(self.block, kind)}
        for statement in self.block.statements(section):
            if isinstance(statement, Assign):
                touched = [statement.target, *(symbol.name for symbol in statement.free_symbols)]
            else:
                touched = [*statement.outputs, *statement.inputs]
            if names & {parse_element(name)[0] for name in touched}:
                return True
        return False

    def _statement(self, statement: Statement, printer: CExpressions, declared: set[str]) -> list[str]:
        if isinstance(statement, Assign):
            place = self._place(statement.target)
            if len(_chain(statement.expression)) > 2 and place == statement.target:
                declared.add(place)
                return self._choice(statement, printer)
            text = printer.doprint(statement.expression).replace("*", " * ").replace("/", " / ")
            if place == statement.target and "[" not in place and place not in declared:
                declared.add(place)
                return [f"const {self.prefix}_real {place} = {text};"]
            return [f"{place} = {text};"]
        return self._call(statement, declared)

    def _choice(self, statement: Assign, printer: CExpressions) -> list[str]:
        """Return a chain of conditions, the first one last: it wins, and all are looked at whatever comes in."""
        *chain, (last, _) = _chain(statement.expression)
        target, select = statement.target, f"{self.prefix}_select"
        lines = [f"{self.prefix}_real {target} = {printer.doprint(last)};"]
        for value, well in reversed(chain):
            lines.append(f"{target} = {select}({printer.doprint(well)}, {target}, {printer.doprint(value)});")
        return lines

    def _call(self, call: Call, declared: set[str]) -> list[str]:
        lines = []
        arguments = [self._argument(name, address=False) for name in call.inputs]
        for name in call.outputs:
            if self.block.signal(parse_element(name)[0]) is None and name not in declared:
                declared.add(name)
                lines.append(f"{self.prefix}_real {name};")
            if name not in call.inputs or not self._is_array(name):
                arguments.append(self._argument(name, address=True))
        numbers = [*self._sizes(call), *(str(number) for number in call.numbers)]
        if call.kernel in GOVERNORS:  # their code is made for these numbers
            numbers = []
        text = f"{self.prefix}_{call.kernel}({', '.join([*numbers, *arguments])})"
        if call.kernel in _FAILURES:
            lines += [f"if (!{text}) {{", f"    return {self.name}_{_FAILURES[call.kernel]};", "}"]
        else:
            lines.append(f"{text};")
        return lines

    def _sizes(self, call: Call) -> list[str]:
        """Return the sizes that a kernel needs: rows and columns of its first matrix, then lengths."""
        shapes = [self._shape(name) for name in (*call.inputs, *call.outputs)]
        if call.kernel == "insert":
            target, source = shapes[0], shapes[1]
            return [str(source[0]), str(padded(target[0])), str(padded(source[0]))]
        if call.kernel == "cholesky_solve":
            return [str(shapes[0][0]), str(shapes[1][1])]
        if call.kernel in ("discretise", "difference", "multiply"):
            return [str(shapes[0][0]), str(shapes[0][1])]
        if call.kernel == "add_product":
            return [str(shapes[2][0]), str(shapes[2][1])]
        if call.kernel == "delay":
            return [str(shapes[0][0])]
        if call.kernel == "lookup":
            return [str(shapes[1][0])]
        if call.kernel == "fluid_torques":
            return [str(shapes[2][0])]
        if call.kernel == "require_definite":
            return [str(shapes[0][0])]
        return []

    def _shape(self, name: str) -> tuple[int, ...]:
        return self.block.shape(name)

    def _is_array(self, name: str) -> bool:
        return bool(self._shape(name))

    def _argument(self, name: str, *, address: bool) -> str:
        place = self._place(name)
        shape = self._shape(name)
        if len(shape) == 2:
            return f"&{place}[0][0]"
        return f"&{place}" if address and not shape else place

    def _place(self, name: str) -> str:
        base, indices = parse_element(name)
        subscripts = "".join(f"[{index}]" for index in reversed(indices))
        for letter, kind in (
            ("p->", "parameters"),
            ("in->", "inputs"),
            ("out->", "outputs"),
            ("s->", "states"),
            ("s->", "derived"),
        ):
            if any(signal.name == base for signal in getattr(self.block, kind)):
                return f"{letter}{base}{subscripts}"
        return f"{base}{subscripts}"
