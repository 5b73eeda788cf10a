"""One row of a table per release: tests/bench/results/ratios.csv."""

from __future__ import annotations

import csv
import datetime
import os
import platform
import statistics
from typing import Mapping

from figures import Values

HERE = os.path.dirname(os.path.abspath(__file__))
FILE = os.path.join(HERE, "results", "ratios.csv")


def machine() -> str:
    """What the processor calls itself."""
    with open("/proc/cpuinfo", encoding="ascii", errors="replace") as file:
        for line in file:
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.machine()


def append(version: str, measured: Mapping[str, Values], path: str = FILE) -> None:
    """Adds a row of medians; a goal that is new gets a column, and what was not measured stays empty."""
    rows: list[dict[str, str]] = []
    columns = ["version", "date", "machine", "cores"]
    if os.path.exists(path):
        with open(path, encoding="ascii", newline="") as file:
            reader = csv.DictReader(file)
            rows, columns = list(reader), list(reader.fieldnames or columns)
    columns += [key for key in measured if key not in columns]
    row = {"version": version, "date": datetime.date.today().isoformat(), "machine": machine(), "cores": str(os.cpu_count())}
    rows.append({**row, **{key: f"{statistics.median(values):.4g}" for key, values in measured.items() if values}})
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
