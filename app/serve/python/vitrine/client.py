"""Session: the methods of the service as methods of an object."""

import atexit
import collections
import inspect
import itertools
import keyword
import os
import subprocess

from .connection import Connection, ConnectionLost, RequestError, error_of
from .picture import Picture
from .process import Program, program

#: Events that are kept for a `Request` until they are read; older ones are dropped.
MOST_EVENTS = 1000

Event = collections.namedtuple("Event", "kind params")


def open(program=None, timeout=None):
    """Starts the program and returns a Session, for `with`. `timeout`: most seconds without a word during a call."""
    return Session(program=program, timeout=timeout)


class Session:
    """Connection to a service: to that at `socket`, or to one of its own, which ends with the session."""

    def __init__(self, socket=None, program=None, timeout=None):
        self._timeout = timeout
        self._ids = itertools.count(1)
        self._connection = None
        self._own = None if socket else Program(program)
        self._path = socket or self._own.socket
        self._program = program
        atexit.register(self.close)
        try:
            self._connection = Connection(self._path, timeout)
            found = self.call("rpc.discover")
        except BaseException:
            self.close()
            raise
        self.version = found["app"]  #: Version of the program.
        self.methods = {method["name"]: method for method in found["methods"]}  #: Name, summary, JSON Schema of params.

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Ends the session and a program of its own. Further calls do nothing."""
        atexit.unregister(self.close)
        if self._connection:
            self._connection.close()
        self._connection = None
        if self._own:
            self._own.stop()
        self._own = None

    def call(self, method, **params):
        """Calls a method by its name and returns its result. Parameters that are None are left out."""
        return self._request(method, params, False).result()

    def start(self, method, **params):
        """Begins a call. Iterate over the Request for its progress, then ask it for its result."""
        return self._request(method, params, True)

    def _request(self, method, params, with_events):
        if not self._connection:
            raise ConnectionLost("The session is closed; open another one.")
        given = {key: value for key, value in params.items() if value is not None}
        return Request(self, self._connection, method, given, with_events)

    def picture(self, exhibit, display=False, **options):
        """Renders a Picture: linear light as in OpenEXR or, for `display`, sRGB-encoded values from 0 to 1 as in a PNG.

        Options are those of `render`; `channels` names more than color: "color,depth,normal,evaluations".
        """
        return self.call("render", exhibit=exhibit, raw="display" if display else "linear", **options)

    def command(self, name, *words, **options):
        """Runs a command of the program and returns its standard output: sixteen_bit=True stands for --sixteen-bit."""
        line = [program(self._program), name, *map(os.fspath, words)]
        for key, value in options.items():
            line += _typed("--" + key.replace("_", "-"), value)
        ended = subprocess.run(line, capture_output=True, text=True, stdin=subprocess.DEVNULL)
        if ended.returncode != 0:
            raise RequestError(ended.stderr.strip().removeprefix("vitrine: "), data={"exitCode": ended.returncode})
        return ended.stdout

    def events(self, timeout=None):
        """Iterates over the events of all connections, on a connection of its own: progress, finished, changed.

        Ends after `timeout` seconds without an event.
        """
        connection = Connection(self._path, timeout)
        try:
            connection.send("events", {}, 0)
            while True:
                message, _ = connection.receive()
                if "error" in message:
                    raise error_of(message)
                if "method" in message:
                    yield Event(message["method"], message["params"])
        except TimeoutError:
            return
        finally:
            connection.close()

    def __getattr__(self, name):
        methods = self.__dict__.get("methods", {})
        if name not in methods:
            raise AttributeError(f"the service has no method {name!r}; it has {', '.join(methods)}")
        return _method(self, methods[name])

    def __dir__(self):
        return sorted({*super().__dir__(), *self.__dict__.get("methods", {})})

    def _lost(self, error):
        """The exception for a lost connection, with how the program ended."""
        how = self._own.end_text() if self._own else ""
        return ConnectionLost(f"{error} {how}".strip())


class Request:
    """A call that was sent. Only one of a session is read at a time: finish it before the next one."""

    def __init__(self, session, connection, method, params, with_events):
        self._session, self._connection, self._id = session, connection, next(session._ids)
        self._with_events = with_events
        self._events = collections.deque(maxlen=MOST_EVENTS)
        self._answer = None
        if with_events:
            self._send("events", {})
        self._send(method, params, self._id)

    def __iter__(self):
        """Iterates over the events "progress" of this request until it ends."""
        while self._events or self._answer is None:
            if self._events:
                yield self._events.popleft()
            else:
                self._read()

    def result(self):
        """Waits for the result. An interruption (Ctrl-C) cancels the request. Raises RequestError with the message."""
        try:
            while self._answer is None:
                self._read()
        except KeyboardInterrupt:
            self.cancel()
            while self._answer is None:
                self._read()
            raise
        message, binary = self._answer
        if "error" in message:
            raise error_of(message)
        return message["result"] if binary is None else Picture(message["result"], binary)

    def cancel(self):
        """Asks the service to stop at its next step; `result` then raises Canceled."""
        self._send("cancel", {"id": self._id})

    def _send(self, method, params, id=None):
        try:
            self._connection.send(method, params, id)
        except ConnectionLost as error:
            raise self._session._lost(error) from None

    def _read(self):
        try:
            message, binary = self._connection.receive()
        except ConnectionLost as error:
            raise self._session._lost(error) from None
        if "method" in message:
            if message.get("params", {}).get("id") == self._id:
                self._events.append(Event(message["method"], message["params"]))
        elif message.get("id") == self._id:
            self._answer = message, binary
            if self._with_events:
                self._send("events", {"off": True})  # Nobody reads them between calls.
        elif message.get("id") is None:
            raise self._session._lost(error_of(message) if "error" in message else "An answer has no id.")


def _python_name(name):
    """The name of a parameter in Python: "with_" for "with", which is a word of the language."""
    return name + "_" if keyword.iskeyword(name) else name


def _service_name(name):
    return name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name


def _method(session, entry):
    """A function for a method of the service, with its parameters as signature and help."""
    schema = entry["params"]
    properties, required = schema.get("properties", {}), schema.get("required", [])
    ordered = [*schema.get("x-positional", []), *required, *sorted(properties)]
    names = list(dict.fromkeys(ordered))
    leading = len(dict.fromkeys([*schema.get("x-positional", []), *required]))
    kinds = inspect.Parameter
    parameters = [
        kinds(
            _python_name(name),
            kinds.POSITIONAL_OR_KEYWORD if i < leading else kinds.KEYWORD_ONLY,
            default=None,
            annotation=_type(properties[name]),
        )
        for i, name in enumerate(names)
    ]

    def call(*args, **params):
        if len(args) > leading:
            raise TypeError(f"{entry['name']} takes {leading} arguments without a name, not {len(args)}")
        params = {_service_name(name): value for name, value in params.items()}
        twice = [name for name in names[: len(args)] if name in params]
        if twice:
            raise TypeError(f"{entry['name']}: {twice[0]} is given twice")
        return session.call(entry["name"], **dict(zip(names, args)), **params)

    call.__name__ = entry["name"]
    call.__signature__ = inspect.Signature(parameters)
    lines = [f"  {_python_name(name)}: {_help(properties[name])}" for name in names]
    call.__doc__ = "\n".join([entry["summary"], *([""] if lines else []), *lines])
    return call


def _type(schema):
    types = {"boolean": bool, "string": str, "number": float, "array": list, "object": dict}
    names = schema["type"] if isinstance(schema["type"], list) else [schema["type"]]
    found = types[names[0]]
    for name in names[1:]:
        found = found | types[name]
    return found


def _help(schema):
    more = [schema[key] for key in ("x-takes", "x-initial") if key in schema]
    return schema["description"] + (f" ({', initially '.join(more)})" if more else "")


def _typed(option, value):
    """The words of a command line that give an option a value, as the service takes it."""
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if isinstance(value, dict):
        return [word for name, member in value.items() for word in (option, f"{name}={member}")]
    if isinstance(value, (list, tuple)):
        if all(isinstance(each, (str, os.PathLike)) for each in value):
            return [option, *map(os.fspath, value)]
        return [option, ("x" if option == "--size" else ",").join(map(str, value))]
    return [option, os.fspath(value) if isinstance(value, os.PathLike) else str(value)]
