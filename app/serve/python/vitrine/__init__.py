"""Client of `vitrine serve`: pictures as numpy arrays, studies as tables.

    import vitrine

    with vitrine.open() as v:                           # starts the program, and ends it
        v.set("sdf_morph", values={"morph": 0.3})
        picture = v.picture("sdf_morph", alone=True, size=(64, 36), channels="color,depth")
        print(picture.array.shape, picture["depth.Z"].min())
        rows = vitrine.table(v.study("sdf_morph", ["hitTolerance"], size="64x36"))

Every method of the service is a method here; `help(v.render)` prints its parameters, which the program itself lists.
"""

from .client import Session, Request, open
from .connection import Canceled, ConnectionLost, Error, RequestError
from .picture import Picture
from .table import table

__all__ = ["Canceled", "ConnectionLost", "Error", "Picture", "Request", "RequestError", "Session", "open", "table"]
