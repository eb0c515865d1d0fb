"""The program, as a child process."""

import os
import select
import shutil
import subprocess
import tempfile
import time

from .connection import Error

STOP_SECONDS = 10


class Program:
    """`vitrine serve` on a socket of its own. It ends with `stop`, and when this process ends in any way."""

    def __init__(self, path=None, start_seconds=120):
        self._folder = tempfile.TemporaryDirectory(prefix="vitrine-")
        self.socket = os.path.join(self._folder.name, "socket")
        self._log = open(os.path.join(self._folder.name, "log"), "w+", encoding="utf-8", errors="replace")
        words = [program(path), "serve", "--socket", self.socket, "--until-input-ends"]
        try:
            self.process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._log)
        except OSError as error:
            self._clean()
            raise Error(f"Cannot start {words[0]}: {error.strerror}.") from error
        try:
            self._wait(start_seconds)
        except BaseException:
            self.process.kill()
            self.stop()
            raise

    def stop(self):
        """Ends the program. Without effect if it ended."""
        self.process.stdin.close()
        try:
            self.process.wait(STOP_SECONDS)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self._clean()

    def words(self):
        """What it wrote to standard error."""
        self._log.flush()
        self._log.seek(0)
        return self._log.read().strip()

    def end_text(self):
        """How it ended, and its last words; empty while it runs."""
        try:
            code = self.process.wait(1)
        except subprocess.TimeoutExpired:
            return ""
        how = f"ended with exit code {code}" if code >= 0 else f"was ended by signal {-code}"
        words = self.words()
        return f"The program {how}" + (f": {words[-1000:]}" if words else ".")

    def _wait(self, seconds):
        """Returns once it listens."""
        said = b""
        end = time.monotonic() + seconds
        while b"\n" not in said:
            if not select.select([self.process.stdout], [], [], max(0, end - time.monotonic()))[0]:
                raise Error(f"The program did not listen within {seconds} seconds.")
            piece = os.read(self.process.stdout.fileno(), 4096)
            if not piece:
                raise Error(self.end_text() or "The program closed its output.")
            said += piece

    def _clean(self):
        if hasattr(self, "process"):
            self.process.stdout.close()
        self._log.close()
        self._folder.cleanup()


def program(path=None):
    """Path of the program: `path`, else that in VITRINE_PROGRAM, else the one on PATH."""
    chosen = path or os.environ.get("VITRINE_PROGRAM") or shutil.which("vitrine")
    if not chosen:
        raise Error("There is no program `vitrine` on PATH; name it with program=..., or in VITRINE_PROGRAM.")
    return os.fspath(chosen)
