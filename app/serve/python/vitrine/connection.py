"""Connection to the service: JSON lines, and the bytes that follow some of them."""

import json
import socket

#: Largest line and largest binary part that are taken. The service sends at most 64 MiB and 128 MiB.
MOST_LINE_BYTES = 256 << 20
MOST_BINARY_BYTES = 1 << 30


class Error(Exception):
    """Anything that this package raises about the service."""


class ConnectionLost(Error):
    """The service ended, closed the connection, or sent what is no message."""


class RequestError(Error):
    """The service refused a request. The text is its message."""

    def __init__(self, message, code=0, data=None):
        super().__init__(message)
        self.code = code  #: Code of JSON-RPC or of the service.
        self.data = data or {}  #: "kind" and "exitCode" of an error that the command line has, too.


class Canceled(RequestError):
    """The request was canceled."""


CANCELED = -32010


def error_of(answer):
    """The exception for an answer with "error"."""
    error = answer["error"]
    kind = Canceled if error.get("code") == CANCELED else RequestError
    return kind(error.get("message", "The service gave no reason."), error.get("code", 0), error.get("data"))


class Connection:
    """One Unix socket. An interrupted call leaves it whole: a message is taken from the buffer once it is complete."""

    def __init__(self, path, timeout=None):
        self._buffer = bytearray()
        self._searched = 0  # No line ends before this index.
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.settimeout(timeout)
        try:
            self._socket.connect(path)
        except OSError as error:
            self._socket.close()
            raise ConnectionLost(f"Cannot connect to the service at {path}: {error.strerror or error}.") from error

    def close(self):
        self._socket.close()

    def send(self, method, params, id=None):
        """Sends a request; without an id, a notification."""
        request = {"jsonrpc": "2.0", "method": method, "params": params}
        if id is not None:
            request["id"] = id
        line = json.dumps(request, allow_nan=False, default=_plain) + "\n"
        try:
            self._socket.sendall(line.encode())
        except OSError as error:
            # The last message of the service explains more than a broken pipe.
            self._raise_last_words()
            raise ConnectionLost(f"The connection to the service broke: {error.strerror or error}.") from error

    def receive(self):
        """The next message and its binary part, or None where it has none."""
        end = self._line_end()
        message = self._parsed(bytes(self._buffer[:end]))
        count = self._binary_size(message)
        self._fill(end + 1 + (count or 0), "within the bytes of an answer" if count else "")
        binary = self._buffer[end + 1 : end + 1 + count] if count is not None else None
        del self._buffer[: end + 1 + (count or 0)]
        self._searched = 0
        return message, binary

    def _line_end(self):
        while True:
            end = self._buffer.find(b"\n", self._searched)
            if end >= 0:
                return end
            self._searched = len(self._buffer)
            if len(self._buffer) > MOST_LINE_BYTES:
                raise ConnectionLost(f"The service sent a line of more than {MOST_LINE_BYTES} bytes.")
            self._fill(len(self._buffer) + 1, "within a line" if self._buffer else "")

    def _fill(self, count, where):
        """Reads until the buffer has `count` bytes."""
        while len(self._buffer) < count:
            try:
                piece = self._socket.recv(1 << 20)
            except TimeoutError:
                raise  # Nothing is lost: the call can be repeated.
            except OSError as error:
                raise ConnectionLost(f"The connection to the service broke: {error.strerror or error}.") from error
            if not piece:
                raise ConnectionLost("The service closed the connection" + (f" {where}." if where else "."))
            self._buffer += piece

    @staticmethod
    def _parsed(line):
        try:
            message = json.loads(line)
        except ValueError as error:
            raise ConnectionLost(f"The service sent a line that is no JSON: {error}.") from error
        if not isinstance(message, dict):
            raise ConnectionLost("The service sent a line that is no message.")
        return message

    @staticmethod
    def _binary_size(message):
        result = message.get("result")
        if not isinstance(result, dict) or "binary" not in result:
            return None
        part = result["binary"]
        count = part.get("bytes") if isinstance(part, dict) else None
        if not isinstance(count, int) or not 0 <= count <= MOST_BINARY_BYTES:
            raise ConnectionLost(f"The service announced {count!r} bytes; at most {MOST_BINARY_BYTES} are taken.")
        return count

    def _raise_last_words(self):
        try:
            message, _ = self.receive()
        except (Error, OSError):
            return
        if "error" in message:
            raise ConnectionLost(str(error_of(message)))


def _plain(value):
    """Paths, and the arrays and numbers of numpy, for JSON."""
    for convert in ("tolist", "__fspath__"):
        if hasattr(value, convert):
            return getattr(value, convert)()
    raise TypeError(f"{type(value).__name__} cannot be sent to the service; give a number, a text, a list or a dict.")
