"""What the measuring programs printed, and ratios of it.

Each program prints one line of JSON for every figure, and anything else that it likes:

    {"name": "w1/afternoon", "ms": [213.0, 214.5]}
    {"name": "http/null/peer", "value": [78000], "unit": "requests/s"}

A name is what was done, a slash, and who did it. The samples of a program that is run once per round count as one, their median;
a program that goes through rounds by itself (tests/bench/http) has one sample for each.
"""

from __future__ import annotations

import json
import statistics
from typing import Callable, Iterator, NamedTuple

Values = list[float]  # one for each round
Measure = Callable[["Figures"], Values]


class Missing(Exception):
    """Nobody has measured it. Its text is the name."""


class Line(NamedTuple):
    name: str
    samples: Values
    unit: str


class Figures:
    def __init__(self) -> None:
        self._rounds: dict[str, dict[int, float]] = {}
        self._units: dict[str, str] = {}

    def add(self, output: str, round_number: int) -> None:
        """What a program printed when it was run in that round."""
        for line in lines(output):
            self._rounds.setdefault(line.name, {})[round_number] = statistics.median(line.samples)
            self._units[line.name] = line.unit

    def add_rounds(self, output: str) -> None:
        """What a program printed that went through all rounds by itself."""
        for line in lines(output):
            self._rounds[line.name] = dict(enumerate(line.samples))
            self._units[line.name] = line.unit

    def values(self, name: str) -> Values:
        return list(self.rounds(name).values())

    def rounds(self, name: str) -> dict[int, float]:
        if name not in self._rounds:
            raise Missing(name)
        return self._rounds[name]

    def medians(self) -> list[tuple[str, float, str]]:
        """Everything by name, with its unit."""
        return [(name, statistics.median(rounds.values()), self._units[name]) for name, rounds in sorted(self._rounds.items())]


def lines(output: str) -> Iterator[Line]:
    for text in output.splitlines():
        if text.startswith('{"name"'):
            row = json.loads(text)
            samples, unit = (row["ms"], "ms") if "ms" in row else (row["value"], row["unit"])
            yield Line(row["name"], [float(sample) for sample in samples], unit)


def value(name: str, scale: float = 1) -> Measure:
    return lambda figures: [scale * number for number in figures.values(name)]


def worst(name: str) -> Measure:
    """For what must never happen: the greatest of all rounds."""
    return lambda figures: [max(figures.values(name))]


def combined(combine: Callable[..., float], *names: str) -> Measure:
    """A number of each round in which all of them were measured."""
    def measure(figures: Figures) -> Values:
        parts = [figures.rounds(name) for name in names]
        return [combine(*(part[number] for part in parts)) for number in parts[0] if all(number in part for part in parts)]
    return measure


def ratio(over: str, under: str, scale: float = 1) -> Measure:
    return combined(lambda a, b: scale * a / b, over, under)
