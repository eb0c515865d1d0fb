# SPDX-License-Identifier: GPL-3.0-or-later
"""Signed distance field atlas of EB Garamond: python3 font_atlas.py [FONT_FOLDER]

Writes font_atlas.png (one channel, 0.5 = outline, larger = inside) and font_atlas.json. Lengths are in em, y up from
the baseline; u, v have their origin in the image's upper left corner. Regular glyphs are in "glyphs", italic ones
in "italic", bold ones in "bold"; kerning is for the regular style, keyed "first second" by code point. Pillow needs Raqm for this."""
import json
import os
import sys

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from scipy import ndimage

HERE = os.path.dirname(os.path.abspath(__file__))
FOLDER = sys.argv[1] if len(sys.argv) > 1 else "/usr/share/fonts/opentype/ebgaramond"
PIXELS, SPREAD, FINE = 40, 6, 12          # px per em in the atlas, spread in px, oversampling
WIDTH = 1024
LINING = ["lnum"]                         # the font's own figures are old-style: 1 would look like a small I

LETTERS = [chr(c) for c in range(33, 127)]
LATIN = [chr(c) for c in range(0xA1, 0x100) if c != 0xAD]
MARKS = list("–—‘’‚“”„†•…′″‹›€−×→↑↓←") + ["\u0152", "\u0153", "\u0160", "\u0161", "\u017d", "\u017e"]
STYLES = {"glyphs": ("EBGaramond12-Regular.otf", LETTERS + LATIN + MARKS),
          "italic": ("EBGaramond12-Italic.otf", LETTERS + list("äöüßéèàç–—’“”…")),
          "bold": ("EBGaramond12-Bold.otf", list("0123456789"))}


def field(font, char):
    """Distance field of one glyph: (array in [0, 1], left, bottom, in em) or None where it has no ink."""
    em = PIXELS * FINE
    left, top, right, bottom = font.getbbox(char, anchor="ls", features=LINING)
    if right <= left or bottom <= top:
        return None
    pad = SPREAD * FINE
    # Whole atlas pixels round the ink.
    x0 = int(np.floor((left - pad) / FINE)) * FINE
    y0 = int(np.floor((top - pad) / FINE)) * FINE
    w = int(np.ceil((right + pad - x0) / FINE))
    h = int(np.ceil((bottom + pad - y0) / FINE))
    image = Image.new("L", (w * FINE, h * FINE), 0)
    ImageDraw.Draw(image).text((-x0, -y0), char, font=font, fill=255, anchor="ls", features=LINING)
    ink = np.asarray(image) >= 128
    if not ink.any():
        return None
    dist = ndimage.distance_transform_edt(ink) - ndimage.distance_transform_edt(~ink)
    dist = np.where(dist > 0, dist - 0.5, dist + 0.5) / FINE
    dist = dist.reshape(h, FINE, w, FINE)[:, FINE // 2 - 1:FINE // 2 + 1, :, FINE // 2 - 1:FINE // 2 + 1].mean((1, 3))
    return np.clip(0.5 + dist / (2 * SPREAD), 0, 1), x0 / em, -(y0 + h * FINE) / em


def exists(font_path, chars):
    font = ImageFont.truetype(font_path, 64)
    missing = font.getmask("\uffff").getbbox(), font.getlength("\uffff")
    keep = []
    for c in chars:
        same = (font.getmask(c).getbbox(), font.getlength(c)) == missing
        if not same:
            keep.append(c)
        else:
            print(f"not in the font: {c} U+{ord(c):04X}")
    return keep


PLAIN = LINING + ["-liga", "-clig", "-dlig"]


def kerning(font, chars):
    """Pairs whose joint advance differs from the sum of the two, in em."""
    em = PIXELS * FINE
    single = {c: font.getlength(c, features=PLAIN) for c in chars}
    out = {}
    for a in chars:
        for b in chars:
            k = (font.getlength(a + b, features=PLAIN) - single[a] - single[b]) / em
            if abs(k) > 0.004:
                out[f"{ord(a)} {ord(b)}"] = round(k, 4)
    return out


def main():
    em = PIXELS * FINE
    boxes, styles = [], {}
    for style, (name, chars) in STYLES.items():
        path = os.path.join(FOLDER, name)
        if not os.path.exists(path):
            sys.exit(f"font_atlas.py: {path} is missing; install fonts-ebgaramond, or name the folder that holds it")
        font = ImageFont.truetype(path, em)
        glyphs = styles[style] = {}
        for c in ["\u0020", "\u00a0"] + exists(path, chars):
            entry = {"advance": round(font.getlength(c, features=LINING) / em, 5)}
            glyphs[str(ord(c))] = entry
            made = field(font, c)
            if made is not None:
                pixels, left, bottom = made
                entry.update(left=round(left, 5), bottom=round(bottom, 5),
                             width=pixels.shape[1] / PIXELS, height=pixels.shape[0] / PIXELS)
                boxes.append((pixels, entry))
    boxes.sort(key=lambda b: -b[0].shape[0])
    x = y = row = 0
    spots = []
    for pixels, entry in boxes:
        h, w = pixels.shape
        if x + w > WIDTH:
            x, y, row = 0, y + row, 0
        spots.append((x, y))
        x, row = x + w, max(row, h)
    height = -(-(y + row) // 64) * 64
    atlas = np.zeros((height, WIDTH))
    for (pixels, entry), (x, y) in zip(boxes, spots):
        h, w = pixels.shape
        atlas[y:y + h, x:x + w] = pixels
        entry.update(u0=x / WIDTH, v0=round(y / height, 7), u1=(x + w) / WIDTH, v1=round((y + h) / height, 7))
    Image.fromarray((atlas * 255 + 0.5).astype(np.uint8), "L").save(os.path.join(HERE, "font_atlas.png"), optimize=True)
    font = ImageFont.truetype(os.path.join(FOLDER, STYLES["glyphs"][0]), em)
    ascent, descent = font.getmetrics()
    basic = LETTERS + list("äöüÄÖÜß’“”–—")
    pairs = kerning(font, basic)
    out = {"size": [WIDTH, height], "pixelsPerEm": PIXELS, "spread": SPREAD, "ascender": round(ascent / em, 5),
           "descender": round(-descent / em, 5), "lineHeight": round((ascent + descent) / em, 5), **styles,
           "kerning": pairs}
    with open(os.path.join(HERE, "font_atlas.json"), "w") as f:
        json.dump(out, f, ensure_ascii=False, separators=(",", ":"))
        f.write("\n")
    print(f"{len(boxes)} glyphs, {WIDTH} x {height}, {len(pairs)} kerning pairs")


main()
