"""Stand-ins for pandas and kloppy: the members of their objects that the package reads, as their documentation names them."""

import datetime
from dataclasses import dataclass
from enum import Enum
from typing import Any, Dict, List, Optional


class DataFrame:
    """Columns by name, as in pandas: ``columns`` and ``frame[name]``."""

    def __init__(self, columns):
        self._columns = dict(columns)

    @property
    def columns(self):
        return list(self._columns)

    def __getitem__(self, name):
        return self._columns[name]


class Unit(Enum):
    METERS = "m"
    CENTIMETERS = "cm"
    NORMED = "normed"


class VerticalOrientation(Enum):
    TOP_TO_BOTTOM = "top-to-bottom"
    BOTTOM_TO_TOP = "bottom-to-top"


@dataclass
class PitchDimensions:
    unit: Unit


@dataclass
class CoordinateSystem:
    vertical_orientation: VerticalOrientation


@dataclass
class Metadata:
    pitch_dimensions: PitchDimensions
    coordinate_system: Optional[CoordinateSystem]


@dataclass(frozen=True)
class Point:
    x: float
    y: float


@dataclass(frozen=True)
class Point3D(Point):
    z: Optional[float]


@dataclass
class PlayerData:
    coordinates: Point


@dataclass
class Frame:
    frame_id: int
    timestamp: datetime.timedelta
    ball_coordinates: Optional[Point]
    players_data: Dict[str, PlayerData]
    dataset: Any = None

    @property
    def players_coordinates(self):
        return {player: data.coordinates for player, data in self.players_data.items()}


@dataclass
class TrackingDataset:
    records: List[Frame]
    metadata: Metadata

    def __post_init__(self):
        for record in self.records:
            record.dataset = self


def tracking_dataset(rows, players=(), unit=Unit.METERS, orientation=VerticalOrientation.BOTTOM_TO_TOP):
    """A dataset with the ball at rows t, x, y, z of the library, y up; without a ball where z is NaN."""
    scale = 100 if unit is Unit.CENTIMETERS else 1
    side = 1 if orientation is VerticalOrientation.TOP_TO_BOTTOM else -1
    records = []
    for i, (t, x, y, z) in enumerate(rows):
        ball = None if z != z else Point3D(scale * x, side * scale * z, scale * y)
        data = {f"player {j}": PlayerData(Point(scale * px, side * scale * pz)) for j, (px, pz) in enumerate(players)}
        records.append(Frame(i, datetime.timedelta(seconds=float(t)), ball, data))
    return TrackingDataset(records, Metadata(PitchDimensions(unit), CoordinateSystem(orientation)))
