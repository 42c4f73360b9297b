"""Measurement files: two columns of a CSV, Parquet or MF4 file."""

from __future__ import annotations

import csv
import importlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ptgen.errors import nearest
from ptgen.testbed.problems import shown

__all__ = ["Columns", "RecordingError", "read_columns"]


class RecordingError(Exception):
    """A measurement file has a problem.

    Attributes
    ----------
    key : str
        The key of the scenario file that is concerned: ``file``, ``time`` or ``column``.
    what, remedy : str
        As in `Problem`.
    """

    def __init__(self, key: str, what: str, remedy: str) -> None:
        super().__init__(what)
        self.key, self.what, self.remedy = key, what, remedy


@dataclass(frozen=True)
class Columns:
    """Two columns of a file, in its own units, and the line that each pair stands in."""

    lines: Sequence[int]
    time: list[float]
    value: list[float]


def read_columns(path: Path, time: str | None, column: str, beside: str = "the scenario file") -> Columns:
    """Read a signal and its time from a measurement file.

    Parameters
    ----------
    path : Path
        A ``.csv``, ``.parquet`` or ``.mf4`` file.
    time : str or None
        Name of the column that holds the time; MF4 needs none.
    column : str
        Name of the column that holds the values.
    beside : str
        What the file is looked for beside.

    Raises
    ------
    RecordingError
        If the file or a column cannot be read, or an entry is no finite number.
    """
    suffix = path.suffix.lower()
    readers = {".csv": _read_csv, ".parquet": _read_parquet, ".mf4": _read_mf4}
    if suffix not in readers:
        raise RecordingError("file", f"must be a .csv, .parquet or .mf4 file, got {path.name}", "convert it")
    if time is None and suffix != ".mf4":
        raise RecordingError("time", "is missing: the name of the column that holds the time", 'add time = "t"')
    try:
        is_file = path.is_file()
    except (OSError, ValueError):  # a name that the system cannot even look for
        is_file = False
    if not is_file:
        raise RecordingError("file", f"{path} does not exist", f"files are looked for beside {beside}")
    try:
        columns = readers[suffix](path, time or "", column)
    except OSError as error:
        raise RecordingError("file", f"{path} cannot be read ({error.strerror or error})", "check it") from None
    if not columns.time:
        raise RecordingError("file", f"{path.name} holds no values", "check the recording")
    return columns


def _read_csv(path: Path, time: str, column: str) -> Columns:
    """Read two columns by the names in the first line; the separator may be a comma, semicolon or tab."""
    columns = Columns([], [], [])
    lines: list[int] = []
    try:
        with path.open(newline="", encoding="utf-8-sig") as stream:
            first = stream.readline()
            stream.seek(0)
            reader = csv.reader(stream, delimiter=max(",;\t", key=first.count))
            header = [name.strip() for name in next(reader, [])]
            indices = [_index(header, "time", time, path), _index(header, "column", column, path)]
            for row in reader:
                if not any(cell.strip() for cell in row):
                    continue
                line = reader.line_num
                lines.append(line)
                columns.time.append(_cell(row, indices[0], time, line, path))
                columns.value.append(_cell(row, indices[1], column, line, path))
    except UnicodeDecodeError:
        raise RecordingError("file", f"{path.name} is not UTF-8", "save it in the encoding UTF-8") from None
    except csv.Error as error:
        raise RecordingError("file", f"{path.name} is no CSV file ({error})", "export it again") from None
    return Columns(lines, columns.time, columns.value)


def _index(header: Sequence[str], key: str, name: str, path: Path) -> int:
    if name not in header:
        remedy = nearest(name, header) if any(header) else "write the names of the columns into the first line"
        raise RecordingError(key, f"{path.name} has no column {shown(name)}", remedy)
    return header.index(name)


def _cell(row: Sequence[str], index: int, name: str, line: int, path: Path) -> float:
    text = row[index].strip() if index < len(row) else ""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        what = f"{path.name}, line {line}, column {shown(name)}: must be a finite number, got {shown(text)}"
        raise RecordingError("file", what, "correct the cell, with a decimal point, or remove the line")
    return number


def _read_parquet(path: Path, time: str, column: str) -> Columns:
    parquet = _extra("pyarrow.parquet", "parquet", path)
    try:
        header = list(parquet.read_schema(path).names)
        for key, name in (("time", time), ("column", column)):
            _index(header, key, name, path)
        table = parquet.read_table(path, columns=list(dict.fromkeys((time, column))))
        pair = [table.column(name).to_pylist() for name in (time, column)]
    except (ValueError, TypeError) as error:  # pyarrow's own errors are children of these
        raise RecordingError("file", f"{path.name} is no Parquet file ({error})", "export it again") from None
    return _numbers(pair[0], pair[1], path, time, column)


def _read_mf4(path: Path, time: str, column: str) -> Columns:
    """Read a channel with its own time stamps, or with the channel `time` of the same group."""
    asammdf = _extra("asammdf", "mdf", path)
    try:
        with asammdf.MDF(path) as recording:
            for key, name in (("time", time), ("column", column)):
                if name and name not in recording:
                    remedy = nearest(name, recording.channels_db)
                    raise RecordingError(key, f"{path.name} has no channel {shown(name)}", remedy)
            signal = recording.get(column)
            stamps = recording.get(time).samples if time else signal.timestamps
            pair = (stamps.tolist(), signal.samples.tolist())
    except RecordingError:
        raise
    except Exception as error:  # asammdf raises what its parser meets
        raise RecordingError("file", f"{path.name} is no MF4 file ({error})", "export it again") from None
    return _numbers(pair[0], pair[1], path, time or "time", column)


def _numbers(time: list[Any], value: list[Any], path: Path, time_name: str, column: str) -> Columns:
    for name, entries in ((time_name, time), (column, value)):
        for index, entry in enumerate(entries):
            if isinstance(entry, bool) or not isinstance(entry, (int, float)) or not math.isfinite(entry):
                place = f"{path.name}, row {index + 1}, column {shown(name)}"
                what = f"{place}: must be a finite number, got {shown(entry)}"
                raise RecordingError("file", what, "correct the value, or remove the row")
    if len(time) != len(value):
        what = f"{path.name}: {shown(column)} has {len(value)} values, but {shown(time_name)} has {len(time)}"
        raise RecordingError("column", what, "choose channels of the same group")
    return Columns(range(1, len(time) + 1), [float(t) for t in time], [float(v) for v in value])


def _extra(module: str, extra: str, path: Path) -> Any:
    try:
        return importlib.import_module(module)
    except ImportError:
        what = f"{path.name} needs the package {module.partition('.')[0]}, which is not installed"
        raise RecordingError("file", what, f"install ptgen[{extra}], or export the columns to CSV") from None
