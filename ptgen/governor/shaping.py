r"""The reference governor in the emitted controller: what stands between rate limiters and control law, Figure 7.4.

1. *Stationary limits* of torque references (7.34), *largest speeds*; see `ptgen.governor.stationary_limits`.
2. The commands that the law would give, :math:`u(\tilde r) = u_0 + D (\tilde r - \tilde r_{k-1})`, from the statements
   of the law itself, so that they hold with whatever gains, switches and disturbances there are.
3. The *sequential governor* (7.37)-(7.43), always: it is what the optimal one falls back to.
4. The *optimal governor* (7.36), if it was emitted and is chosen, with predicted rows of a `ConstraintSet`. These rows
   belong to the parameters of the design. With others it is not used, and the status says so.

The parameter ``governor`` chooses while the controller runs: 0 none, 1 sequential, 2 sequential modified (7.43),
3 optimal. A change does not jump: the governor goes on from the references of the last step, and when it is switched
off, these go on to the wanted ones with twice their rate. What is not finite does not get into a shaped reference.

Status ``governor_status``: 0 nothing is held back, 1 a reference is, 2 a limit cannot be kept (``governor_slack_<M>``
tells by how much, whatever is chosen), 3 the optimal governor found no solution in its iterations, 4 the parameters are
not those of the design. In the last two cases the sequential governor's references are taken.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray
from sympy.logic.boolalg import And

from ptgen.block.block import Assign, Block, Signal, Table, element
from ptgen.control.envelope import Envelope
from ptgen.control.references import Reference
from ptgen.control.shaper import shaped_reference
from ptgen.control.unlimited_law import UnlimitedLaw
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of
from ptgen.errors import ControlError, Problem
from ptgen.governor.constraint_set import ConstraintSet
from ptgen.governor.digits import rounded, significant
from ptgen.governor.prediction import Prediction
from ptgen.governor.stationary_limits import limited_speeds, limited_torques
from ptgen.governor.step_order import step_order
from ptgen.testbed.governor_settings import GovernorKind, GovernorSettings

__all__ = ["KINDS", "ReferenceGovernor", "governor_signals"]

Array = NDArray[np.float64]

KINDS: tuple[GovernorKind, ...] = ("none", "sequential", "sequential_modified", "optimal")
"""Kinds of governors; the parameter ``governor`` is the place in this list."""

HALF = sp.Rational(1, 2)

_FINITE = sp.Float("1e30")
_INSIDE = sp.Float("0.99999")
"""Share of a limit of the law up to which the governor goes, so that rounding does not reach the limit."""

_LACKING = sp.Float("1e-5")
"""Share of a machine's torque by which a limit is missed before the status says so."""


@dataclass(frozen=True)
class ReferenceGovernor:
    """A `ptgen.control.shaper.Shaper`; see the module.

    Attributes
    ----------
    settings : GovernorSettings
    prediction : Prediction
        For the torques at rest.
    constraints : ConstraintSet or None
        Needed for the optimal governor.
    """

    settings: GovernorSettings
    prediction: Prediction
    constraints: ConstraintSet | None = None

    def shape(
        self,
        w: ControllerWriter,
        references: Sequence[Reference],
        law: UnlimitedLaw,
        envelopes: Sequence[Envelope],
        measured: Mapping[str, sp.Symbol],
        losses: Sequence[sp.Symbol],
    ) -> None:
        """Write the governor; see `ptgen.control.shaper.Shaper`."""
        m = len(references)
        chosen = self._parameters(w, references)
        before = [self._before(w, reference) for reference in references]
        limits = _narrowed(w, law, envelopes, before)
        within = limited_torques(w, references, limits.stationary, self.prediction.stationary, measured)
        within |= limited_speeds(w, references, self.prediction.speeds_at_rest)
        vectors = {
            "wanted": [within[k] for k in range(m)],
            "before": before,
            "least": [least for least, _ in limits.present],
            "most": [most for _, most in limits.present],
        }
        for name, entries in vectors.items():
            _fill(w, f"governor_{name}", f"{name}, as the governor takes it", entries, "what the governor works with")
        self._commands(w, law, before)
        pattern = np.array([[law.gain[i, j] != 0 for j in range(m)] for i in range(m)])
        order = step_order(pattern)
        self._sequential(w, references, chosen, order)
        proposal, found = "governor_sequential", None
        if self.constraints is not None:
            found = self._optimal(w, law, measured, before, chosen, limits.stationary)
            proposal = "governor_proposal"
        self._release(w, references, chosen, proposal)
        removal = self.constraints.removal if self.constraints is not None else 0.0
        self._report(w, references, chosen, limits.rated, found, removal)

    # -- parts

    def _parameters(self, w: ControllerWriter, references: Sequence[Reference]) -> sp.Symbol:
        """Declare what can be chosen while the controller runs; return which governor is."""
        settings = self.settings
        level = float(KINDS.index(settings.kind))
        text = "reference governor: " + ", ".join(f"{k} {name}" for k, name in enumerate(KINDS) if k <= level)
        chosen = w.parameter("governor", "", text.replace("_", " "), level, most=level)
        share = "share of every machine's torque that the governor leaves free"
        w.parameter("governor_reserve", "", f"{share}, eps_1 (7.30)", settings.reserve, most=0.5)
        share = "further share that it leaves free of torques at rest and of speeds"
        w.parameter(
            "governor_stationary_reserve", "", f"{share}, eps_inf (7.32)", settings.stationary_reserve, most=0.5
        )
        w.parameter("governor_tie", "rad/s", "speed references that differ by less stay together", settings.tie)
        if any(reference.unit == "N m" for reference in references):
            w.parameter(
                "torque_rate_min",
                "N m/s",
                "rate that the sequential governor leaves a torque",
                settings.torque_rate_min,
            )
            w.parameter(
                "torque_reserve",
                "N m",
                "torque of a torque-controlled machine that it leaves free",
                settings.torque_reserve,
            )
        if self.constraints is not None:
            w.parameter(
                "governor_torque_weight", "", "weight of a torque reference, alpha_T (7.36)", settings.torque_weight
            )
            w.parameter(
                "governor_speed_weight", "", "weight of a speed reference, alpha_omega (7.36)", settings.speed_weight
            )
        return chosen

    @staticmethod
    def _before(w: ControllerWriter, reference: Reference) -> sp.Symbol:
        name = shaped_reference(reference)
        state = w.state(name, reference.unit, f"{reference.signal} behind the reference governor")
        start = w.previous(state, reference.limited, here=True)
        return w.assign(f"{name}_before", start, "references of the last step")

    @staticmethod
    def _commands(w: ControllerWriter, law: UnlimitedLaw, before: Sequence[sp.Symbol]) -> None:
        """Write what the law would ask for with the references of the last step, and what a change of these adds."""
        m, source = len(before), "commands without limits (7.42)"
        chain = dict(zip(law.references, before, strict=True))
        free = [signal_symbol(f"{name}_unchanged") for name in w.design.machines]
        for machine in law.order:
            chain[law.symbols[machine]] = w.assign(free[machine].name, law.commands[machine].xreplace(chain), source)
        _fill(w, "governor_free", "commands with the references of the last step", free, source)
        w.array("governor_gain", "what a change of the references adds to the commands", m, m)
        known = {*w.parameters, *w.derived}
        for (i, j), entry in np.ndenumerate(np.array(law.gain)):
            if entry == 0:
                continue
            value = sp.sympify(entry)
            if {symbol.name for symbol in value.free_symbols} <= known and not value.is_Atom:
                names = w.design.machines
                text = f"change of the command of {names[i]} with the reference of {names[j]}"
                value = w.derive(f"{names[i]}_follows_{names[j]}", "", text, value)
            w.assign(f"governor_gain[{i},{j}]", value, source)

    def _sequential(
        self, w: ControllerWriter, references: Sequence[Reference], chosen: sp.Symbol, order: Sequence[int]
    ) -> None:
        m, source = len(references), "sequential governor (7.37)-(7.43)"
        torques = [reference.unit == "N m" for reference in references]
        zero = sp.Integer(0)
        reserve = [signal_symbol("torque_reserve") if torque else zero for torque in torques]
        _fill(w, "governor_room", "torque that others leave free", reserve, source)
        step = zero
        if any(torques):
            step = w.derive(
                "torque_step_min",
                "N m",
                "step of a torque reference that others leave room for",
                signal_symbol("sample_time") * signal_symbol("torque_rate_min"),
            )
        steps = [step if torque else zero for torque in torques]
        _fill(w, "governor_rate", "step of a reference that others leave room for", steps, source)
        groups = [0.0 if torque else 1.0 for torque in torques]
        w.tables["governor_groups"] = Table(
            "governor_groups", "", "references with the same positive number may be led together", groups
        )
        modified = sp.Piecewise((sp.Integer(1), chosen > sp.Rational(3, 2)), (zero, True))
        w.assign("governor_modified", modified, source)
        w.array("governor_sequential", "references that the sequential governor proposes", m)
        arguments = ("wanted", "before", "free", "gain", "least", "most", "room", "rate", "tie", "modified", "groups")
        w.call(
            "sequential_governor",
            ("governor_sequential",),
            tuple(f"governor_{name}" for name in arguments),
            source,
            tuple(number for machine in order for number in (machine, machine)),
        )

    def _optimal(
        self,
        w: ControllerWriter,
        law: UnlimitedLaw,
        measured: Mapping[str, sp.Symbol],
        before: Sequence[sp.Symbol],
        chosen: sp.Symbol,
        plain: Sequence[tuple[sp.Expr, sp.Expr]],
    ) -> sp.Symbol:
        """Write the optimal governor; return whether it is in force.

        What the law adds to a torque after limiting it, the damping, fades while the references stay. The limits must
        not be narrowed by what it is now, as those of the steps to come would be, too: for such a machine the row of
        this step is the torque before it is added, and the predicted rows add what it will be.
        """
        constraints, m, source = self.constraints, len(before), "optimal governor (7.36)"
        if constraints is None:
            raise ValueError("the optimal governor needs a constraint set")
        known = self._known(w, law, measured, before)
        prediction = constraints.prediction
        table = np.hstack([prediction.estimate.values, -prediction.steady])
        names = (*prediction.estimate.signals, *(f"wanted {name}" for name in prediction.references))
        text = "state of the closed loop less the one in which it would rest, per"
        w.tables["governor_estimate"] = Table("governor_estimate", "", text, significant(table), names)
        wanted = [element("governor_wanted", k) for k in range(m)]
        _fill(w, "governor_signals", "what the state follows from", [*known, *wanted], source)
        w.array("governor_deviation", "state less the one in which it would rest", len(table))
        w.call("multiply", ("governor_deviation",), ("governor_estimate", "governor_signals"), source)
        added = self._added(w, law, measured)
        rows_x, rows_r, counts = _with_added(constraints, {machine: row for machine, (_, row) in added.items()})
        if not sum(counts):  # no row but those of this step
            rows_x, rows_r = np.zeros((1, len(table))), np.zeros((1, m))
        text = "what predicted commands add to those of this step, per"
        w.tables["governor_rows_x"] = Table("governor_rows_x", "", f"{text} state", rounded(rows_x), prediction.states)
        w.tables["governor_rows_r"] = Table(
            "governor_rows_r", "", f"{text} change of a wanted reference", rounded(rows_r), prediction.references
        )
        narrow = sp.Float(1 / (1 + constraints.removal), 17)
        free = [
            element("governor_free", k) - added[k][0] if k in added else element("governor_free", k) for k in range(m)
        ]
        _fill(w, "governor_free_kept", "commands, less what is added to them after a limit", free, source)
        for place, side in enumerate(("least", "most")):
            entries = [narrow * (plain[k][place] if k in added else element(f"governor_{side}", k)) for k in range(m)]
            _fill(w, f"governor_{side}_tight", f"{side}, less what rows cost that were left out", entries, source)
        kinds = ["torque" if torque else "speed" for torque in prediction.torque_references]
        weights = [signal_symbol(f"governor_{kind}_weight") for kind in kinds]
        _fill(w, "governor_weight", "what a reference is worth", weights, source)
        holds = w.assign("governor_set_holds", self._set_holds(w, law), source)
        in_force = sp.Piecewise((holds, chosen > sp.Rational(5, 2)), (sp.Integer(0), True))
        in_force = w.assign("governor_in_force", in_force, source)
        w.array("governor_proposal", "references that are proposed", m)
        w.array("governor_lacking", "by how much limits had to be widened", m)
        arguments = (
            "in_force", "wanted", "before", "free_kept", "gain", "least_tight", "most_tight", "deviation", "rows_x",
            "rows_r", "weight", "tie", "groups", "sequential",
        )  # fmt: skip
        w.state("governor_iterations", "", "steps of the optimal governor's solver", monitor=True)
        w.call(
            "optimal_governor",
            ("governor_proposal", "governor_lacking", "governor_iterations", "governor_outcome"),
            tuple(f"governor_{name}" for name in arguments),
            source,
            (*counts, self.settings.iterations),
        )
        return in_force

    def _known(
        self, w: ControllerWriter, law: UnlimitedLaw, measured: Mapping[str, sp.Symbol], before: Sequence[sp.Symbol]
    ) -> list[sp.Expr]:
        """Return the signals that the state of the prediction follows from."""
        applied = [signal_symbol(f"{name}_applied") for name in w.design.machines]
        now = dict(zip(law.references, before, strict=True)) | dict(zip(law.symbols, applied, strict=True))
        result, missing = [], []
        estimate = self.prediction.estimate
        for name, kind in zip(estimate.signals, estimate.kinds, strict=True):
            if kind == "sensor" and name in measured:
                result.append(measured[name])
            elif kind == "estimate":
                value = law.estimates[f"{name}_estimate"].xreplace(now)
                result.append(w.assign(f"{name}_acting", value, "testing torque with the torques of the last step"))
            elif kind == "applied":
                result.append(signal_symbol(f"{name.removesuffix('_torque')}_applied"))
            elif kind == "state" and name in w.states:
                result.append(signal_symbol(name))
            else:
                missing.append(name)
        if missing:
            what = f"the optimal governor needs {', '.join(missing)}, which the controller does not have"
            raise ControlError(Problem("governor.kind", what, 'choose "sequential_modified"'))
        return result

    def _added(
        self, w: ControllerWriter, law: UnlimitedLaw, measured: Mapping[str, sp.Symbol]
    ) -> dict[int, tuple[sp.Expr, Array]]:
        """Return what the law adds to torques that it has limited, and the same per state of the prediction.

        Machines are left out for which it does not follow from the states; their limits of this step are narrowed.
        """
        values = {signal_symbol(name): sp.Float(signal.value, 17) for name, signal in w.parameters.items()}
        values |= {signal_symbol(f"{s.name}_now"): value for s, value in tuple(values.items())}
        for statement in w.preparation:
            if isinstance(statement, Assign):
                values[signal_symbol(statement.target)] = statement.expression.xreplace(values)
        estimate, found = self.prediction.estimate, dict[int, tuple[sp.Expr, Array]]()
        for machine, parts in enumerate(law.within):
            if len(parts) != 1:
                continue
            rest = sp.expand(law.commands[machine] - parts[0][1])
            per_signal = {
                name: sp.diff(rest, measured[name])
                for name, kind in zip(estimate.signals, estimate.kinds, strict=True)
                if kind == "sensor" and name in measured
            }
            if sp.expand(rest - sp.Add(*(slope * measured[name] for name, slope in per_signal.items()))) != 0:
                continue
            slopes = [sp.sympify(per_signal.get(name, 0)).xreplace(values) for name in estimate.signals]
            if any(slope.free_symbols for slope in slopes):
                continue
            wanted = np.array([float(slope) for slope in slopes])
            row = np.linalg.lstsq(estimate.values.T, wanted, rcond=None)[0]
            if np.abs(row @ estimate.values - wanted).max() <= 1e-9 * np.abs(wanted).max(initial=0.0):
                found[machine] = rest, row
        return found

    @staticmethod
    def _set_holds(w: ControllerWriter, law: UnlimitedLaw) -> sp.Expr:
        """Return 1 if everything that the law depends on is as in the design, else 0."""
        sources = {s.target: s.free_symbols for s in w.preparation if isinstance(s, Assign)}
        names, pending = set[str](), set(law.reads)
        while pending:
            name = pending.pop()
            if name in names:
                continue
            names.add(name)
            pending |= {symbol.name for symbol in sources.get(name, ())}
        same = [
            sp.Eq(signal_symbol(name), sp.Float(signal.value, 17), evaluate=False)
            for name, signal in w.parameters.items()
            # what sensors miss of an inertia is no part of the prediction, so a change of it takes nothing away
            if name in names and "_sensor_inertia_" not in name
        ]
        designed = w.derive(
            "governor_designed",
            "",
            "1 while gains and all else that the prediction rests on are those of the design",
            sp.Piecewise((sp.Integer(1), And(*same)), (sp.Integer(0), True), evaluate=False),
        )
        moving = [
            sp.Eq(signal_symbol(name), sp.Float(w.parameters[name.removesuffix("_now")].value, 17), evaluate=False)
            for name in sorted(names)
            if name.endswith("_now") and name.removesuffix("_now") in w.parameters
        ]
        return sp.Piecewise((designed, And(*moving)), (sp.Integer(0), True), evaluate=False) if moving else designed

    @staticmethod
    def _release(w: ControllerWriter, references: Sequence[Reference], chosen: sp.Symbol, proposal: str) -> None:
        """Write the shaped references: those proposed, or on the way to the limited ones; only finite ones."""
        source = "shaped references (7.13)"
        bound = w.derive("governor_finite", "", "what counts as finite", _FINITE)
        off = chosen <= HALF
        for k, reference in enumerate(references):
            name = shaped_reference(reference)
            limited = w.assign(f"{name}_target", reference.limited, source)
            distance = w.assign(f"{name}_distance", limited - signal_symbol(f"{name}_before"))
            step = 2 * reference.step
            way = signal_symbol(f"{name}_before") + greatest_of(-step, smallest_of(step, distance))
            on = element(proposal, k)
            value = sp.Piecewise((on, sp.Not(off)), (way, sp.Abs(distance) > step), (limited, True))
            w.assign(f"{name}_proposed", value)
            w.call("guard", (name, f"{name}_sound"), (f"{name}_proposed", bound, limited), source)

    @staticmethod
    def _report(
        w: ControllerWriter,
        references: Sequence[Reference],
        chosen: sp.Symbol,
        rated: Sequence[sp.Expr],
        in_force: sp.Symbol | None,
        removal: float,
    ) -> None:
        """Write what limits lack, and the status."""
        m, source = len(references), "status of the governor"
        changes = [
            signal_symbol(shaped_reference(r)) - signal_symbol(f"{shaped_reference(r)}_before") for r in references
        ]
        _fill(w, "governor_change", "change of the shaped references", changes, source)
        w.array("governor_response", "what it adds to the commands", m)
        w.call("multiply", ("governor_response",), ("governor_gain", "governor_change"), source)
        lacking: list[sp.Expr] = []
        zero = sp.Integer(0)
        for k, name in enumerate(w.design.machines):
            state = w.state(
                f"governor_slack_{name}",
                "N m",
                f"by how much the command of {name} is beyond what the governor keeps it in",
                monitor=True,
            )
            text = f"what the control law asks of {name}, before any limit"
            asked = w.state(f"governor_demand_{name}", "N m", text, monitor=True)
            w.assign(asked.name, element("governor_free", k) + element("governor_response", k), source)
            beyond = greatest_of(0, asked - element("governor_most", k), element("governor_least", k) - asked)
            small = sp.Piecewise((beyond, beyond > _LACKING * rated[k]), (zero, True), evaluate=False)
            if in_force is not None:
                # Rows that were left out may take as much as limits were tightened for them: that is no lack.
                lack = element("governor_lacking", k)
                least = sp.Float(removal / 2) * rated[k]
                lack = sp.Piecewise((lack, lack > least), (zero, True), evaluate=False)
                small = sp.Piecewise((lack, in_force > HALF), (small, True), evaluate=False)
            w.assign(state.name, small, source)
            lacking.append(state)
        held = [
            sp.Ne(signal_symbol(shaped_reference(r)), signal_symbol(f"{shaped_reference(r)}_target"))
            for r in references
        ]
        status = w.state(
            "governor_status",
            "",
            "0 nothing is held back, 1 a reference is, 2 a limit cannot be kept, 3 no solution in the bound of"
            " iterations, 4 parameters are not those of the design; with 3 and 4 the sequential governor holds",
            monitor=True,
        )
        value = sp.Piecewise((2, greatest_of(*lacking, 0) > 0), (1, sp.Or(*held)), (0, True), evaluate=False)
        if in_force is None:
            w.state("governor_iterations", "", "steps of the governor's solver", monitor=True)
            w.assign("governor_iterations", zero, source)
        else:
            value = sp.Piecewise((4, chosen > sp.Rational(5, 2)), (value, True), evaluate=False)
            outcome = signal_symbol("governor_outcome")
            hardly = And(outcome > 3 * HALF, outcome < 5 * HALF, greatest_of(*lacking, 0) <= 0)
            outcome = sp.Piecewise((1, hardly), (outcome, outcome > HALF), (1, sp.Or(*held)), (0, True), evaluate=False)
            value = sp.Piecewise((outcome, in_force > HALF), (value, True), evaluate=False)
        w.assign(status.name, sp.Piecewise((value, chosen > HALF), (zero, True), evaluate=False), source)


def governor_signals(controller: Block) -> tuple[Signal, ...]:
    """Return what a recording should hold of the governor in a controller: shaped references, status, slack, demands.

    None without a governor.
    """
    own = ("governor_status", "governor_iterations", "governor_slack_", "governor_demand_")
    return tuple(s for s in controller.states if s.name.endswith("_shaped") or s.name.startswith(own))


@dataclass(frozen=True)
class _Limits:
    """Least and largest torque (N m) of every machine in this step and at rest, and what it can give."""

    present: tuple[tuple[sp.Expr, sp.Expr], ...]
    stationary: tuple[tuple[sp.Expr, sp.Expr], ...]
    rated: tuple[sp.Expr, ...]


def _with_added(constraints: ConstraintSet, added: Mapping[int, Array]) -> tuple[Array, Array, tuple[int, ...]]:
    """Return the rows of a set, and how many each machine has, for machines to whose torque something is added.

    Their rows hold what is added, as it will be then; and there is one of this step besides.
    """
    p, rows_x, rows_r, counts = constraints.prediction, constraints.rows_x(), constraints.rows_r(), constraints.counts
    parts_x, parts_r, first = [np.zeros((0, len(p.A)))], [np.zeros((0, len(p.references)))], 0
    for machine, count in enumerate(counts):
        own_x, own_r = rows_x[first : first + count], rows_r[first : first + count]
        if machine in added:
            own_x = np.vstack([np.zeros(len(p.A)), own_x]) + added[machine]
            own_r = np.vstack([np.zeros(len(p.references)), own_r])
        parts_x.append(own_x)
        parts_r.append(own_r)
        first += count
    return np.vstack(parts_x), np.vstack(parts_r), tuple(len(part) for part in parts_x[1:])


def _narrowed(
    w: ControllerWriter, law: UnlimitedLaw, envelopes: Sequence[Envelope], before: Sequence[sp.Symbol]
) -> _Limits:
    """Write the limits that the governor keeps: those of the envelope, and those that the law keeps inside, (7.30)."""
    present, stationary = [], []
    share = 1 - signal_symbol("governor_reserve")
    source = "limits that the governor keeps (7.30)"
    for machine, (name, envelope) in enumerate(zip(w.design.machines, envelopes, strict=True)):
        least, most = [share * envelope.least], [share * envelope.most]
        shares = [share]
        for inner, torque in law.within[machine]:
            rest = sp.expand(law.commands[machine] - torque)
            if rest.free_symbols & {*law.references, *law.symbols}:
                raise ValueError(f"what the law adds to a limited torque of {name} depends on references")
            least.append(_INSIDE * inner * envelope.least + rest)
            most.append(_INSIDE * inner * envelope.most + rest)
            shares.append(inner)
        present.append(
            (
                w.assign(f"{name}_governed_least", greatest_of(*least) if len(least) > 1 else least[0], source),
                w.assign(f"{name}_governed_most", smallest_of(*most) if len(most) > 1 else most[0], source),
            )
        )
        kept = smallest_of(*shares) if len(shares) > 1 else shares[0]
        stationary.append((kept * envelope.least, kept * envelope.most))
    return _Limits(tuple(present), tuple(stationary), tuple(envelope.most - envelope.least for envelope in envelopes))


def _fill(w: ControllerWriter, name: str, text: str, entries: Sequence[sp.Expr], source: str) -> None:
    """Declare a local vector and assign its entries."""
    w.array(name, text, len(entries))
    for k, entry in enumerate(entries):
        if entry != 0:  # it begins with zeros
            w.assign(f"{name}[{k}]", entry, source)
