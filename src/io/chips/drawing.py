"""What a reader found in a file."""
from __future__ import annotations

from collections import Counter, defaultdict
from dataclasses import dataclass, field

import numpy as np

MOST_POINTS = 2_000_000  # of all that is read: beyond it parsing takes minutes
MOST_SHAPES = 300_000


class Refused(Exception):
    """What is wrong with the file and what to do, a sentence or two each."""

    def __init__(self, *messages: str):
        super().__init__("\n".join(messages))
        self.messages = messages


@dataclass
class Options:
    """The keys of [geometry]; lengths in µm, None where not given."""
    layer: str | None = None
    unit: float | None = None
    pixel: float | None = None
    chord: float | None = None
    fluid: str = "inside"

    @property
    def off(self) -> float:
        """How far the chords of a curve may be off [µm]."""
        return 0.02 if self.chord is None else self.chord


@dataclass
class Line:
    """Points of a closed outline or of an open piece of one, (n, 2) [µm]; closed without repeating the first."""
    points: np.ndarray
    closed: bool
    what: str  # "CIRCLE #2F"
    layer: str


@dataclass
class Drawing:
    lines: list[Line] = field(default_factory=list)
    unit: str = ""  # "1 mm, which $INSUNITS = 4 says"
    union: bool = False  # what overlaps is joined; else what lies within another turns it round
    remarks: list[str] = field(default_factory=list)
    skipped: Counter = field(default_factory=Counter)  # "layer off: A" and how many shapes
    refusals: dict = field(default_factory=lambda: defaultdict(Counter))  # layer: what cannot be read, and how many
    kinds: dict = field(default_factory=lambda: defaultdict(Counter))  # layer: kinds of shapes that were read
    taken: list[str] = field(default_factory=list)
    points: int = 0

    def add(self, layer: str, points, closed: bool, kind: str, name: str = ""):
        points = np.asarray(points, dtype=float).reshape(-1, 2)
        self.points += len(points)
        if self.points > MOST_POINTS or len(self.lines) >= MOST_SHAPES:
            raise Refused(f"the file holds more than {MOST_POINTS} points or {MOST_SHAPES} shapes; keep only the layer of the "
                          "channels in it, or write a larger chord")
        if not np.all(np.isfinite(points)) or (len(points) and np.abs(points).max() > 1e12):
            raise Refused(f"{kind} {name} has a coordinate that is no finite number".replace("  ", " "))
        self.kinds[layer][kind] += 1
        self.lines.append(Line(points, closed, f"{kind} {name}".strip(), layer))

    def refuse(self, layer: str, what: str):
        self.refusals[layer][what] += 1

    def select(self, wanted: str | None):
        """Keeps one layer. Without a choice there must be one alone."""
        layers = sorted(set(self.kinds) | set(self.refusals))
        listed = ", ".join(f"{layer} ({sum(self.kinds[layer].values())})" for layer in layers) or "none"
        if wanted is None:
            drawn = [layer for layer in layers if self.kinds[layer]]
            if len(drawn) > 1:
                raise Refused(f"shapes lie on several layers, and one alone can be that of the channels; write layer = "
                              f"\"{drawn[0]}\", or another of (with how many shapes): {listed}")
            self.taken = layers
        else:
            if not self.kinds[wanted] and not self.refusals[wanted]:
                layers = [layer for layer in layers if layer != wanted]
                raise Refused(f"layer \"{wanted}\" holds nothing that can be seen; layers with shapes (and how many): {listed}"
                              + self.told_skipped())
            for layer in layers:
                if layer != wanted:
                    self.skipped[f"on layer {layer}"] += sum(self.kinds[layer].values()) + sum(self.refusals[layer].values())
            self.taken = [wanted]
        refused = [f"{what} ({count} on layer {layer})" for layer in self.taken for what, count in self.refusals[layer].items()]
        if refused:
            raise Refused(*refused)
        self.lines = [line for line in self.lines if line.layer in self.taken]
        if not self.lines:
            raise Refused("no outline is in the file" + self.told_skipped())

    def told_skipped(self) -> str:
        return "; left out: " + ", ".join(f"{count} {why}" for why, count in self.skipped.items()) if self.skipped else ""


def counted(count: int, what: str) -> str:
    return f"{count} {what}" + ("" if count == 1 else "s")


def place(point) -> str:
    return f"({point[0]:.6g}, {point[1]:.6g}) um"
