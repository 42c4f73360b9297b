"""Blocks: the only thing that is emitted, and the one description that all evaluators share.

A block is a list of assignments of scalar expressions and of calls of named kernels. It has these sections:

``prepare``
    what follows from the parameters alone; run at initialisation and whenever parameters change, and at the start of a
    step if an input has changed that it depends on, see `Tracked`,
``refresh``
    the rest of ``prepare``, run after it: what a step has to compute anew if only quick tracked inputs have changed,
``step``
    from inputs and states to new states and outputs,
``measure``
    outputs that follow from the states alone; run at the end of every step, and after initialisation.

Besides its signals it has tables: constant arrays, the same for all instances.

Statements run in order and overwrite what they assign, in every evaluator alike. In expressions an element of
an array is the symbol ``name[i]`` or ``name[i,j]``, see `element`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray
from sympy.logic.boolalg import Boolean

__all__ = [
    "Alarm",
    "Assign",
    "Block",
    "Call",
    "Fault",
    "Section",
    "Signal",
    "Statement",
    "Table",
    "Tracked",
    "element",
    "parse_element",
]

Section = Literal["prepare", "refresh", "step", "measure"]


@dataclass(frozen=True)
class Signal:
    """A named quantity of a block.

    Attributes
    ----------
    name : str
        A C identifier.
    unit : str
        SI unit; empty for numbers and for arrays of mixed units.
    description : str
        One line.
    shape : tuple of int
        Empty for a scalar, ``(n,)`` or ``(n, m)``.
    value : float
        Default of a parameter, initial value of a state, what an input is at rest.
    entries : tuple of str
        Names of the entries of an array, where they have any.
    least : float or None
        The value that a parameter must exceed (`least_allowed` false) or reach (true); None if any finite
        value will do.
    least_allowed : bool
    most : float or None
        The largest value of a parameter or input; None if any finite value will do.
    monitor : bool
        Whether this state only watches: it acts on the outputs through a fault alone, so it is no part of the
        dynamics of the loop.
    """

    name: str
    unit: str
    description: str
    shape: tuple[int, ...] = ()
    value: float = 0.0
    entries: tuple[str, ...] = ()
    least: float | None = None
    least_allowed: bool = True
    most: float | None = None
    monitor: bool = False

    @property
    def size(self) -> int:
        """Number of scalars."""
        size = 1
        for length in self.shape:
            size *= length
        return size


@dataclass(frozen=True)
class Table:
    """A constant array that kernels and expressions may read in every section.

    Attributes
    ----------
    name : str
        A C identifier.
    unit : str
        SI unit; empty for numbers and for arrays of mixed units.
    description : str
        One line.
    values : tuple of float, or tuple of tuple of float
        The entries, row by row; any array that NumPy understands is taken.
    entries : tuple of str
        Names of the entries of a vector, or of the columns of a matrix, where they have any.

    Raises
    ------
    ValueError
        If the array is empty, has another number of axes than one or two, or an entry is not finite.

    Examples
    --------
    >>> Table("weights", "", "what each is worth", [1, 100]).values
    (1.0, 100.0)
    """

    name: str
    unit: str
    description: str
    values: tuple[float, ...] | tuple[tuple[float, ...], ...] | ArrayLike
    entries: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        array = np.array(self.values, dtype=np.float64)
        if array.ndim not in (1, 2) or not array.size or not np.isfinite(array).all():
            raise ValueError(f"table {self.name}: give finite numbers in one or two axes, at least one of them")
        rows = array.tolist()
        object.__setattr__(self, "values", tuple(rows if array.ndim == 1 else map(tuple, rows)))

    @property
    def shape(self) -> tuple[int, ...]:
        """``(n,)`` or ``(n, m)``."""
        return self.array().shape

    def array(self) -> NDArray[np.float64]:
        """Return the entries as an array."""
        return np.array(self.values, dtype=np.float64)


@dataclass(frozen=True)
class Assign:
    """``target = expression``; `target` is a scalar or an element; `source` names the equation.

    With a `condition` the target, a declared scalar, keeps its value unless the condition holds.
    """

    target: str
    expression: sp.Expr
    source: str = ""
    condition: Boolean | None = None

    @property
    def free_symbols(self) -> set[sp.Symbol]:
        """Symbols that the assignment reads."""
        symbols = set(self.expression.free_symbols)
        return symbols if self.condition is None else symbols | self.condition.free_symbols


@dataclass(frozen=True)
class Call:
    """A call of a kernel: ``outputs = kernel(inputs)``; the kernels are listed in `ptgen.block.kernels`.

    `numbers` are constant integers that the kernel takes besides, such as offsets.
    """

    kernel: str
    outputs: tuple[str, ...]
    inputs: tuple[str, ...]
    source: str = ""
    numbers: tuple[int, ...] = ()


Statement = Assign | Call


@dataclass(frozen=True)
class Alarm:
    """What it means if the state `state` has the value `value` after a step: a name for the status, and a text."""

    state: str
    value: int
    name: str
    text: str


@dataclass(frozen=True)
class Fault:
    """A cause for which the block stops: what the state ``fault`` becomes, a name for the status, and a text."""

    status: int
    name: str
    text: str


@dataclass(frozen=True)
class Tracked:
    """A quantity that `prepare` depends on though it changes at run time: the state `state` follows the input `input`.

    A step first takes the input over into the state, and runs `prepare` again if that has changed it.

    Attributes
    ----------
    state, input : str
    quick : bool
        Whether only `refresh` depends on it, so that nothing else is run again.
    """

    state: str
    input: str
    quick: bool = False


@dataclass(frozen=True)
class Block:
    """A named set of signals and statements; see the module.

    Attributes
    ----------
    name, description : str
    parameters, inputs, outputs, states : tuple of Signal
    derived : tuple of Signal
        What `prepare` and `refresh` compute.
    arrays : tuple of Signal
        Local arrays; local scalars need no declaration.
    prepare, refresh, step, measure : tuple of Statement
    faults : tuple of Fault
        What the state ``fault`` may tell; empty for blocks without supervision.
    alarms : tuple of Alarm
        What a step may have to tell though it went on.
    tracked : tuple of Tracked
        States that `prepare` depends on, and the inputs that they follow.
    tables : tuple of Table
        Constant arrays.
    """

    name: str
    description: str
    parameters: tuple[Signal, ...]
    inputs: tuple[Signal, ...]
    outputs: tuple[Signal, ...]
    states: tuple[Signal, ...]
    derived: tuple[Signal, ...] = ()
    arrays: tuple[Signal, ...] = ()
    prepare: tuple[Statement, ...] = ()
    step: tuple[Statement, ...] = ()
    measure: tuple[Statement, ...] = ()
    faults: tuple[Fault, ...] = ()
    alarms: tuple[Alarm, ...] = ()
    tracked: tuple[Tracked, ...] = ()
    tables: tuple[Table, ...] = ()
    refresh: tuple[Statement, ...] = ()
    _index: dict[str, Signal] = field(default_factory=dict, init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        for signal in self.signals():
            if signal.name in self._index:
                raise ValueError(f"block {self.name}: the signal {signal.name} is declared twice")
            self._index[signal.name] = signal
        used: set[str] = set()
        for section in ("prepare", "refresh", "step", "measure"):
            used |= self._check_section(section)
        names = [table.name for table in self.tables]
        if twice := {name for name in names if names.count(name) > 1} | (set(names) & set(self._index)):
            raise ValueError(f"block {self.name}: {sorted(twice)} declared twice")
        if idle := set(names) - used:
            raise ValueError(f"block {self.name}: the tables {sorted(idle)} are not used")

    def signals(self) -> Iterator[Signal]:
        """Yield every declared signal."""
        yield from self.parameters
        yield from self.inputs
        yield from self.outputs
        yield from self.states
        yield from self.derived
        yield from self.arrays

    def signal(self, name: str) -> Signal | None:
        """Return the declared signal `name`, or None for a local scalar."""
        return self._index.get(name)

    def declared(self, name: str) -> Signal:
        """Return the declared signal `name`.

        Raises
        ------
        KeyError
            If the block declares no such signal.
        """
        return self._index[name]

    def table(self, name: str) -> Table | None:
        """Return the table `name`, or None if there is none."""
        return next((table for table in self.tables if table.name == name), None)

    def shape(self, name: str) -> tuple[int, ...]:
        """Return the shape of the signal or table `name`; that of a local scalar is empty."""
        found = self.signal(name) or self.table(name)
        return found.shape if found is not None else ()

    def statements(self, section: str) -> tuple[Statement, ...]:
        """Return the statements of `section`."""
        sections = {"prepare": self.prepare, "refresh": self.refresh, "step": self.step, "measure": self.measure}
        return sections[section]

    def locals(self, section: str) -> tuple[str, ...]:
        """Return the local scalars of `section` in the order in which they are assigned."""
        names: dict[str, None] = {}
        for statement in self.statements(section):
            targets = (statement.target,) if isinstance(statement, Assign) else statement.outputs
            for target in targets:
                base = parse_element(target)[0]
                if base not in self._index:
                    names[base] = None
        return tuple(names)

    def _check_section(self, section: str) -> set[str]:
        """Check that every name is declared, or assigned before it is used; return the names that are used."""
        tables = {table.name for table in self.tables}
        known = set(self._index) | tables
        read: set[str] = set()
        for statement in self.statements(section):
            if isinstance(statement, Assign):
                used = {parse_element(str(symbol))[0] for symbol in statement.free_symbols}
                targets = {parse_element(statement.target)[0]}
                if statement.condition is not None and statement.target not in self._index:
                    raise ValueError(f"block {self.name}, {section}: {statement.target} may be left without a value")
            else:
                used = {parse_element(name)[0] for name in statement.inputs}
                targets = {parse_element(name)[0] for name in statement.outputs}
            if missing := used - known:
                raise ValueError(f"block {self.name}, {section}: {sorted(missing)} used before assignment")
            if constant := targets & tables:
                raise ValueError(f"block {self.name}, {section}: the tables {sorted(constant)} are constant")
            known |= targets
            read |= used
        return read


def element(name: str, *indices: int) -> sp.Symbol:
    """Return the symbol of an element of an array.

    Examples
    --------
    >>> element("x", 2)
    x[2]
    """
    return sp.Symbol(f"{name}[{','.join(map(str, indices))}]", real=True)


def parse_element(text: str) -> tuple[str, tuple[int, ...]]:
    """Split ``name[i,j]`` into its name and indices.

    Examples
    --------
    >>> parse_element("x[2]")
    ('x', (2,))
    >>> parse_element("torque")
    ('torque', ())
    """
    if not text.endswith("]"):
        return text, ()
    base, indices = text[:-1].split("[")
    return base, tuple(int(index) for index in indices.split(","))
