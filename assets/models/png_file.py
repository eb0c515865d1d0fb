# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the PNG files that the program reads when it starts, so that they cost little to decode.

python3 assets/models/png_file.py FILE...          writes the files anew, with the same pixels
python3 assets/models/png_file.py --check FILE...  changes nothing; exit 1 where a file was written by other means

Rows are stored as they are, or as differences from the pixel to the left or above: whichever makes the smallest file. The
other two filters, Average and Paeth, took half a percent off the hall's files together, and half of the decoder's time: it
computes each byte from the one before.
"""
import struct
import sys
import zlib

CHEAP = (0, 1, 2)  # None, Sub, Up: PNG 1.2, 6.


def chunks(path):
    with open(path, "rb") as f:
        data = f.read()
    at = 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + size]
        at += 12 + size


def filters(path):
    """The filters of a file's rows."""
    body = b""
    for kind, data in chunks(path):
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", data[:10])
        elif kind == b"IDAT":
            body += data
    rows = zlib.decompress(body)
    samples = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[color]
    return set(rows[::(width * samples * bits + 7) // 8 + 1][:height])


def save_png(path, pixels):
    """Writes 8-bit samples: height x width, or height x width x 3 or 4."""
    import numpy as np
    height, width = pixels.shape[:2]
    samples = 1 if pixels.ndim == 2 else pixels.shape[2]
    rows = np.ascontiguousarray(pixels, np.uint8).reshape(height, width * samples)
    left, above = rows.copy(), rows.copy()
    left[:, samples:] -= rows[:, :-samples]
    above[1:] -= rows[:-1]
    smallest = None
    for kind, data in zip(CHEAP, (rows, left, above)):
        raw = np.concatenate([np.full((height, 1), kind, np.uint8), data], 1).tobytes()
        for strategy in (zlib.Z_DEFAULT_STRATEGY, zlib.Z_FILTERED):
            packer = zlib.compressobj(9, zlib.DEFLATED, 15, 9, strategy)
            packed = packer.compress(raw) + packer.flush()
            if smallest is None or len(packed) < len(smallest):
                smallest = packed

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n")
        f.write(chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[samples], 0, 0, 0)))
        f.write(chunk(b"IDAT", smallest) + chunk(b"IEND", b""))


def main(arguments):
    if arguments in ([], ["--check"]):
        print("png_file.py: name the files")
        return 2
    if arguments[:1] == ["--check"]:
        slow = [path for path in arguments[1:] if not filters(path) <= set(CHEAP)]
        for path in slow:
            print(f"{path}: its rows are filtered by Average or Paeth; run python3 assets/models/png_file.py {path}")
        return 1 if slow else 0
    import numpy as np
    from PIL import Image
    for path in arguments:
        save_png(path, np.asarray(Image.open(path)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
