"""The CasADi evaluator of blocks: functions for optimisation, differentiation and code generation.

Whether a signal that is not finite is supervised as in the other evaluators depends on how CasADi evaluates
branches, which it does not promise; all other behaviour is that of the other evaluators.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import casadi as ca

from ptgen.block.block import Assign, Block, Call, Signal, parse_element
from ptgen.block.casadi_fluid import fluid_torques
from ptgen.block.casadi_friction import backlash_step, friction_step, is_closed_form
from ptgen.block.casadi_governor import optimal_governor, sequential_governor
from ptgen.block.expressions import Arithmetic, evaluate
from ptgen.block.kernels import TAYLOR_DEGREE, rounding_unit

__all__ = ["CASADI_KERNELS", "CasadiBlock"]

_ARITHMETIC = Arithmetic(
    absolute=ca.fabs,
    minimum=ca.fmin,
    maximum=ca.fmax,
    select=ca.if_else,
    exponential=ca.exp,
    sine=ca.sin,
    floor=ca.floor,
    sign=ca.sign,
    root=ca.sqrt,
    both=ca.logic_and,
    either=ca.logic_or,
    negate=ca.logic_not,
)


class CasadiBlock:
    """CasADi functions of a block.

    Every argument and result is a column vector that stacks the signals of one kind in their order, arrays row
    by row; `names` tells which entry is which.

    Attributes
    ----------
    prepare : casadi.Function
        ``(parameters) -> (derived)``; tracked quantities have their initial values
    step : casadi.Function
        ``(parameters, derived, states, inputs) -> (states, outputs)``
    measure : casadi.Function
        ``(parameters, derived, states) -> (outputs)``
    """

    def __init__(self, block: Block) -> None:
        self.block = block
        self._kind = _kind(block)
        self.prepare = self._prepare()
        self.step = self._step()
        self.measure = self._measure()

    @staticmethod
    def names(signals: tuple[Signal, ...]) -> list[str]:
        """Return the name of every entry of a stacked vector."""
        result = []
        for signal in signals:
            if not signal.shape:
                result.append(signal.name)
            elif len(signal.shape) == 1:
                result += [f"{signal.name}[{i}]" for i in range(signal.shape[0])]
            else:
                result += [f"{signal.name}[{i},{j}]" for i in range(signal.shape[0]) for j in range(signal.shape[1])]
        return result

    def _prepare(self) -> Any:
        parameters = ca.MX.sym("parameters", sum(s.size for s in self.block.parameters))
        table = self._tables(ca.MX) | _unstack(parameters, self.block.parameters)
        table |= {item.state: ca.MX(self.block.declared(item.state).value) for item in self.block.tracked}
        self._prepare_again(table)
        derived = _stack(table, self.block.derived, ca.MX)
        return ca.Function(f"{self.block.name}_prepare", [parameters], [derived], ["parameters"], ["derived"])

    def _prepare_again(self, table: dict[str, Any]) -> None:
        """Run the preparation in a table, and leave its local arrays empty."""
        arrays = {s.name: ca.MX.zeros(*_matrix_shape(s)) for s in self.block.arrays}
        table |= {s.name: ca.MX.zeros(*_matrix_shape(s)) for s in self.block.derived} | arrays
        self._run("prepare", table)
        self._run("refresh", table)
        table |= arrays

    def _follow(self, table: dict[str, Any]) -> None:
        """Compute in a table what depends on the tracked quantities in it."""
        if any(not item.quick for item in self.block.tracked):
            self._prepare_again(table)
        elif self.block.tracked:
            self._run("refresh", table)

    def _step(self) -> Any:
        symbols = self._symbols("parameters", "derived", "states", "inputs")
        table = self._table(symbols)
        table |= {item.state: table[item.input] for item in self.block.tracked}
        self._follow(table)
        self._run("step", table)
        self._run("measure", table)
        return ca.Function(
            f"{self.block.name}_step",
            list(symbols.values()),
            [_stack(table, self.block.states, self._kind), _stack(table, self.block.outputs, self._kind)],
            list(symbols),
            ["next_states", "outputs"],
        )

    def _measure(self) -> Any:
        symbols = self._symbols("parameters", "derived", "states")
        table = self._table(symbols)
        self._follow(table)
        self._run("measure", table)
        outputs = _stack(table, self.block.outputs, self._kind)
        return ca.Function(f"{self.block.name}_measure", list(symbols.values()), [outputs], list(symbols), ["outputs"])

    def _tables(self, kind: Any) -> dict[str, Any]:
        return {table.name: kind(ca.DM(table.array())) for table in self.block.tables}

    def _symbols(self, *kinds: str) -> dict[str, Any]:
        return {kind: self._kind.sym(kind, sum(s.size for s in getattr(self.block, kind))) for kind in kinds}

    def _table(self, symbols: Mapping[str, Any]) -> dict[str, Any]:
        table = self._tables(self._kind)
        for kind, vector in symbols.items():
            table |= _unstack(vector, getattr(self.block, kind))
        table |= {s.name: self._kind.zeros(*_matrix_shape(s)) for s in self.block.arrays + self.block.outputs}
        return table

    def _run(self, section: str, table: dict[str, Any]) -> None:
        for statement in self.block.statements(section):
            if isinstance(statement, Assign):
                lookup = _Elements(table)
                value = evaluate(statement.expression, lookup, _ARITHMETIC)
                if statement.condition is not None:
                    value = ca.if_else(
                        evaluate(statement.condition, lookup, _ARITHMETIC), value, table[statement.target]
                    )
                _store(table, statement.target, value)
                continue
            _call(statement, table)


def _kind(block: Block) -> Any:
    """Return the type of the step's expressions: scalars, unless a kernel is a function that is called.

    The preparation is too large for scalars; it is a part of the step if a quantity is tracked that is not quick.
    """
    if any(not item.quick for item in block.tracked):
        return ca.MX
    for statement in block.step:
        if isinstance(statement, Call) and statement.kernel == "optimal_governor":
            return ca.MX
        if isinstance(statement, Call) and statement.kernel == "friction_step":
            n = block.declared(statement.inputs[1]).shape[0]
            if not is_closed_form(n, statement.numbers[0]):
                return ca.MX
    return ca.SX


def _call(call: Call, table: dict[str, Any]) -> None:
    arguments = [_Elements(table)[name] for name in call.inputs]
    results = CASADI_KERNELS[call.kernel](*arguments, *call.numbers)
    if len(call.outputs) == 1:
        results = (results,)
    for name, result in zip(call.outputs, results, strict=True):
        _store(table, name, result)


def _matrix_shape(signal: Signal) -> tuple[int, int]:
    padded = (*signal.shape, 1, 1)
    return padded[0], padded[1]


def _unstack(vector: Any, signals: tuple[Signal, ...]) -> dict[str, Any]:
    result, start = {}, 0
    for signal in signals:
        rows, columns = _matrix_shape(signal)
        # reshape is column by column, the stack goes row by row
        part = vector[start : start + signal.size]
        result[signal.name] = ca.reshape(part, columns, rows).T if columns > 1 else part
        start += signal.size
    return result


def _stack(table: Mapping[str, Any], signals: tuple[Signal, ...], kind: Any) -> Any:
    parts = [ca.vec(kind(table[signal.name]).T) for signal in signals]
    return ca.vertcat(*parts) if parts else kind(0, 1)


class _Elements(Mapping[str, Any]):
    def __init__(self, table: Mapping[str, Any]) -> None:
        self._table = table

    def __getitem__(self, key: str) -> Any:
        name, indices = parse_element(key)
        if not indices:
            return self._table[name]
        return self._table[name][indices if len(indices) == 2 else indices[0]]

    def __iter__(self) -> Iterator[str]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)


def _store(table: dict[str, Any], target: str, value: Any) -> None:
    name, indices = parse_element(target)
    if not indices:
        table[name] = value
        return
    changed = type(table[name])(table[name])
    changed[indices if len(indices) == 2 else indices[0]] = value
    table[name] = changed


def _insert(target: Any, source: Any, row: int, column: int, first: int, count: int) -> Any:
    result = type(target)(target)
    result[row : row + source.shape[0], column : column + count] = source[:, first : first + count]
    return result


def _discretise(A: Any, scale: Any, duration: Any, squarings: int) -> Any:
    n, total = A.shape
    X = A * ca.repmat(scale.T, n, 1) / ca.repmat(scale[:n], 1, total)
    X = ca.vertcat(X, ca.MX.zeros(total - n, total)) * (duration / 2.0**squarings)
    identity = ca.MX.eye(total)
    E = identity + X / TAYLOR_DEGREE
    for k in range(TAYLOR_DEGREE - 1, 0, -1):
        E = identity + X @ E / k
    for _ in range(squarings):
        E = E @ E
    return E[:n, :] * ca.repmat(scale[:n], 1, total) / ca.repmat(scale.T, n, 1)


def _add_product(y: Any, x: Any, A: Any, T: Any) -> Any:
    result = type(y)(y)
    result[: x.shape[0]] = x + A @ T
    return result


def _delay(buffer: Any, value: Any, steps: Any) -> tuple[Any, Any, Any]:
    history = ca.vertcat(value, buffer)
    length = buffer.shape[0]
    late, early = history[0], history[1]
    for index in range(1, length):
        late = ca.if_else(steps == index, history[index], late)
        early = ca.if_else(steps == index, history[index + 1], early)
    return history[:length], late, early


def _guard(value: Any, bound: Any, held: Any) -> tuple[Any, Any]:
    sound = ca.fabs(value) <= bound
    return ca.if_else(sound, value, held), ca.if_else(sound, 1.0, 0.0)


def _lookup(value: Any, grid: Any, slope: Any, level: Any) -> Any:
    result = level[0] + slope[0] * ca.fmax(value - grid[0], 0.0)
    for k in range(1, grid.shape[0]):
        result = ca.if_else(value >= grid[k], level[k] + slope[k] * (value - grid[k]), result)
    return result


def _lasting(sound: Any, time: Any, step: Any, allowed: Any) -> Any:
    counted = ca.fmin(time, allowed)
    return ca.if_else(sound > 0.5, ca.fmax(counted, step) - step, counted + step)


def _swings(value: Any, limit: Any, side: Any, count: Any, decay: Any) -> tuple[Any, Any]:
    after = ca.if_else(value > limit, 1.0, ca.if_else(value < -limit, -1.0, side))
    return after, ca.fmax(0.0, count - decay) + ca.if_else(after == side, 0.0, 1.0)


CASADI_KERNELS: dict[str, Any] = {
    "difference": lambda A, B: A - B,
    "rounding_unit": lambda: ca.MX(float(rounding_unit())),
    "insert": _insert,
    "cholesky_solve": lambda M, right: ca.solve(M, right, "ldl"),
    "discretise": _discretise,
    "require_definite": lambda K, semidefinite: (),
    "multiply": lambda A, x: A @ x[: A.shape[1]],
    "add_product": _add_product,
    "delay": _delay,
    "guard": _guard,
    "lasting": _lasting,
    "share": lambda value: ca.fmin(1.0, ca.fmax(0.0, value)),
    "still": lambda value, before, time, step: ca.if_else(value == before, time + step, 0.0),
    "swings": _swings,
    "lookup": _lookup,
    "friction_step": friction_step,
    "backlash_step": backlash_step,
    "fluid_torques": fluid_torques,
    "sequential_governor": sequential_governor,
    "optimal_governor": optimal_governor,
}
