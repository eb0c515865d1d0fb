"""Pictures as numpy arrays."""

import numpy

from .connection import ConnectionLost


class Picture:
    """Pixels of a picture: `array[row, column, channel]`, float32, row 0 at the top.

    `picture["depth.Z"]` is one channel, `picture.rgb` the color, `picture.answer` the rest of what `render` answered.
    """

    def __init__(self, answer, data):
        part = answer["binary"]
        try:
            self.channels = tuple(part["channels"])
            shape = tuple(part["shape"])
            if part["type"] != "float32" or len(shape) != 3 or shape[2] != len(self.channels):
                raise ValueError(f"{part['type']}, {shape}")
            self.array = numpy.frombuffer(data, dtype="<f4").reshape(shape)
        except (KeyError, TypeError, ValueError) as error:
            raise ConnectionLost(f"The service sent a picture that is not what it says: {error}.") from error
        self.answer = {key: value for key, value in answer.items() if key != "binary"}

    def __getitem__(self, channel):
        if channel not in self.channels:
            raise KeyError(f"there is no channel {channel!r}; there are {', '.join(self.channels)}")
        return self.array[:, :, self.channels.index(channel)]

    @property
    def rgb(self):
        return self.array[:, :, :3]

    @property
    def notes(self):
        return self.answer["notes"]

    @property
    def report(self):
        """What ran and what was skipped, with times, counters and memory, of a picture with frame_report=True."""
        return self.answer["frame_report"]

    def __array__(self, dtype=None, copy=None):
        return numpy.array(self.array, dtype=dtype, copy=bool(copy) or dtype not in (None, self.array.dtype))

    def __repr__(self):
        height, width = self.array.shape[:2]
        return f"<Picture of {width} x {height} pixels: {', '.join(self.channels)}>"
