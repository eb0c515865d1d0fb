"""Draws the diagrams of the pages as SVG: python3 assets/pages/diagrams.py

With --check it writes nothing, and says which files differ from what it would write (exit status 1). The files keep to
what Qt's SVG reader knows (SVG Tiny 1.2): no style sheets, markers, clipping or scripts. They have a light ground of
their own, so that they can be read on light and on dark pages, and no words, so that all languages share them.
"""

import math
import os
import sys

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'figures')

PAPER, INK, GRAY, PALE = '#fbfaf6', '#26282b', '#8b8d8f', '#e3e1da'
BLUE, SKY, ORANGE, PEACH = '#1c68ad', '#d6e6f4', '#c8561a', '#f7dcc8'


def number(value):
    return f'{value:.2f}'.rstrip('0').rstrip('.') if abs(value) >= 0.005 else '0'


class Drawing:
    """SVG file that is built element by element; coordinates are pixels, y points down."""

    def __init__(self, width, height):
        self.size = width, height
        self.lines = [f'<rect width="{width}" height="{height}" rx="8" fill="{PAPER}"/>']

    def add(self, name, fill, stroke, thick, dashes=None, **attributes):
        text = ''.join(f' {key}="{number(value) if isinstance(value, (int, float)) else value}"'
                       for key, value in attributes.items())
        text += f' fill="{fill or "none"}"'
        if stroke:
            text += f' stroke="{stroke}" stroke-width="{number(thick)}"'
        if dashes:
            text += f' stroke-dasharray="{dashes}"'
        self.lines.append(f'<{name}{text}/>')

    def line(self, a, b, stroke=INK, width=1.5, dashes=None):
        self.add('line', None, stroke, width, dashes, x1=a[0], y1=a[1], x2=b[0], y2=b[1])

    def circle(self, center, radius, fill=None, stroke=None, width=1.5, dashes=None):
        self.add('circle', fill, stroke, width, dashes, cx=center[0], cy=center[1], r=radius)

    def rect(self, x, y, width, height, fill=None, stroke=None, line=1.5):
        self.add('rect', fill, stroke, line, None, x=x, y=y, width=width, height=height)

    def shape(self, points, fill=None, stroke=None, width=1.5, dashes=None, closed=True):
        path = ' '.join(f'{number(x)},{number(y)}' for x, y in points)
        self.add('polygon' if closed else 'polyline', fill, stroke, width, dashes, points=path)

    def arrow(self, a, b, stroke=INK, width=1.5, head=9, dashes=None):
        length = math.dist(a, b)
        x, y = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        base = b[0] - head * x, b[1] - head * y
        self.line(a, base, stroke, width, dashes)
        self.shape([b, (base[0] - 0.4 * head * y, base[1] + 0.4 * head * x),
                    (base[0] + 0.4 * head * y, base[1] - 0.4 * head * x)], stroke)

    def span(self, a, b, stroke=INK, width=1.5):
        """Draws a dimension line with an arrow at both ends."""
        middle = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
        self.arrow(middle, a, stroke, width, 7)
        self.arrow(middle, b, stroke, width, 7)

    def text(self, at, words, fill=INK, size=19, anchor='middle', italic=True, below=''):
        """Writes words centered at this height; `below` becomes a subscript."""
        style = ' font-style="italic"' if italic else ''
        x, y = at[0], at[1] + 0.35 * size
        if below:
            wide = 0.55 * size * len(words)
            start = x - (wide + 0.34 * size * len(below)) / 2 if anchor == 'middle' else x
            self.text((start, at[1]), words, fill, size, 'start', italic)
            self.text((start + wide, at[1] + 0.3 * size), below, fill, 0.68 * size, 'start', False)
            return
        self.lines.append(f'<text x="{number(x)}" y="{number(y)}" fill="{fill}" font-family="DejaVu Sans, Arial, sans-serif"'
                          f' font-size="{number(size)}" text-anchor="{anchor}"{style}>{words}</text>')

    def eye(self, at, toward, size=15, fill=INK):
        """Draws an eye that looks along the direction `toward` (radians)."""
        def turned(x, y):
            c, s = math.cos(toward), math.sin(toward)
            return at[0] + c * x - s * y, at[1] + s * x + c * y
        lid = [turned(-size, 0)]
        lid += [turned(size * math.cos(a), 0.75 * size * math.sin(a)) for a in [k * math.pi / 12 for k in range(-6, 7)]]
        self.shape(lid, '#ffffff', fill, 1.8)
        self.circle(turned(0.62 * size, 0), 0.33 * size, fill)

    def svg(self):
        width, height = self.size
        head = f'<svg xmlns="http://www.w3.org/2000/svg" version="1.2" baseProfile="tiny" width="{width}" height="{height}" ' \
               f'viewBox="0 0 {width} {height}">'
        return '\n'.join([head, *self.lines, '</svg>', ''])


def along(origin, direction, t):
    return origin[0] + direction[0] * t, origin[1] + direction[1] * t


def unit(a, b):
    length = math.dist(a, b)
    return (b[0] - a[0]) / length, (b[1] - a[1]) / length


def sphere_tracing():
    """A ray, and around each of its stops the circle that is known to be empty."""
    picture = Drawing(700, 330)
    ball, radius = (292, 268), 78
    corner = (560, 60)  # Upper left corner of the block on the right.

    def nearest(p):
        to_ball = math.dist(p, ball) - radius
        block = (max(p[0], corner[0]), min(max(p[1], corner[1]), 290))
        to_block = math.dist(p, block)
        if to_ball < to_block:
            return to_ball, along(ball, unit(ball, p), radius)
        return to_block, block

    eye, goal = (50, 120), (560, 206)
    direction = unit(eye, goal)
    stops, t = [], 0.0
    while True:
        p = along(eye, direction, t)
        distance, touched = nearest(p)
        stops.append((p, distance, touched))
        if distance < 2:
            break
        t += distance
    picture.circle(ball, radius, PALE, INK, 2)
    picture.rect(corner[0], corner[1], 110, 230, PALE, INK, 2)
    for p, distance, _ in stops[:-1]:
        picture.circle(p, distance, None, BLUE, 1.4)
    picture.arrow(eye, along(stops[-1][0], direction, -3), INK, 2.2, 12)
    for p, distance, touched in stops[:-1]:
        if distance > 24:
            picture.line(p, touched, BLUE, 1.2, '4,4')
    for i, (p, distance, _) in enumerate(stops):
        picture.circle(p, 4.5 if i < len(stops) - 1 else 6, INK if i < len(stops) - 1 else ORANGE)
        if i < 2 or i == len(stops) - 1:
            picture.text((p[0] + (8, -2)[i] if i < 2 else p[0] - 16, p[1] - 20), 'p', INK if i < 2 else ORANGE, 20, below=str(i))
    p, _, touched = stops[0]
    picture.text(((p[0] + touched[0]) / 2 - 26, (p[1] + touched[1]) / 2 + 8), 'f(p₀)', BLUE, 18)
    picture.eye((eye[0] - 20, eye[1] - 3), math.atan2(direction[1], direction[0]))
    return picture


def occlusion():
    """A corner: rays over the hemisphere on the left, five samples up the normal on the right."""
    picture = Drawing(700, 330)
    reach, wall = 200, 64

    def corner(left):
        floor, side = 285, left + wall
        picture.shape([(left - 165, floor), (side, floor), (side, 50), (side + 26, 50), (side + 26, floor + 26),
                       (left - 165, floor + 26)], PALE, INK, 2)
        return left, floor

    p = corner(190)
    arc = [(p[0] + reach * math.cos(a), p[1] - reach * math.sin(a)) for a in
           [math.acos(wall / reach) + (math.pi - math.acos(wall / reach)) * k / 40 for k in range(41)]]
    arc = [q for q in arc if q[0] > 26]
    picture.shape(arc, None, GRAY, 1.2, '5,4', False)
    for k in range(16):
        angle = math.pi * (k + 0.5) / 16
        d = math.cos(angle), -math.sin(angle)
        hit = wall / d[0] if d[0] > 0 else math.inf
        if hit < reach:
            picture.line(p, along(p, d, hit), ORANGE, 2)
            picture.circle(along(p, d, hit), 4, ORANGE)
        else:
            end = min(reach, (p[0] - 26) / -d[0] if d[0] < 0 else reach)
            picture.arrow(p, along(p, d, end), BLUE, 1.6, 9)
    picture.circle(p, 6, INK)
    picture.text((p[0] - 4, p[1] + 14), 'p', INK, 19)

    p = corner(500)
    heights = [i * i * reach / 25 for i in range(1, 6)]
    for h in reversed(heights):
        f = min(h, wall)
        picture.circle((p[0], p[1] - h), f, SKY if h == heights[-1] else None, BLUE, 1.3)
    picture.arrow(p, (p[0], p[1] - reach - 42), INK, 2, 11)
    picture.text((p[0] + 14, p[1] - reach - 40), 'n', INK, 19)
    for i, h in enumerate(heights):
        at = p[0], p[1] - h
        picture.circle(at, 4.5, INK)
        f, left = min(h, wall), 405
        if h > wall:  # The wall is nearer than the height: the length that is missing.
            picture.line(at, (p[0] + wall, at[1]), BLUE, 2)
        bar = 0.42 * h
        picture.rect(left - bar, at[1] - 4, bar, 8, PEACH, ORANGE, 1)
        picture.rect(left - bar * f / h, at[1] - 4, bar * f / h, 8, BLUE)
        if i > 0:
            picture.text((left + 18, at[1]), 'h', INK, 17, below=str(i + 1))
    picture.text((p[0] + wall / 2 + 2, p[1] - heights[3] - 13), 'f', BLUE, 19)
    picture.circle(p, 6, INK)
    picture.text((p[0], p[1] + 14), 'p', INK, 19)
    return picture


def lens_views():
    """Three lenses over four views each; two eyes see the same view under all lenses."""
    picture = Drawing(700, 472)
    pitch, radius, index, views = 150, 96, 1.56, 4
    left, apex = 125, 130
    focal = radius * index / (index - 1)
    bottom = apex + focal
    edge = apex + radius - math.sqrt(radius ** 2 - (pitch / 2) ** 2)
    colors = [SKY, PALE, '#efede6', PEACH]
    for lens in range(3):
        for view in range(views):
            x = left + lens * pitch + view * pitch / views
            picture.rect(x, bottom, pitch / views, 24, colors[view], GRAY, 1)
            picture.text((x + pitch / views / 2, bottom + 12), str(view + 1), INK, 15, italic=False)
    outline = [(left, bottom)]
    for lens in range(3):
        middle = left + (lens + 0.5) * pitch
        for k in range(25):
            x = -pitch / 2 + pitch * k / 24
            outline.append((middle + x, apex + radius - math.sqrt(radius ** 2 - x ** 2)))
    outline.append((left + 3 * pitch, bottom))
    picture.shape(outline, '#eef4f4', INK, 2)
    for slant, color in ((math.radians(18), BLUE), (math.radians(-18), ORANGE)):
        incoming = -math.sin(slant), math.cos(slant)  # Downwards, from the right for a positive slant.
        for lens in range(3):
            middle = left + (lens + 0.5) * pitch
            for x in (-32, 0, 32):
                x += radius * math.sin(slant) * 0.45
                height = math.sqrt(radius ** 2 - x ** 2)
                at = middle + x, apex + radius - height
                normal = x / radius, -height / radius
                cosine = -(incoming[0] * normal[0] + incoming[1] * normal[1])
                ratio = 1 / index
                bend = ratio * cosine - math.sqrt(1 - ratio ** 2 * (1 - cosine ** 2))
                inside = ratio * incoming[0] + bend * normal[0], ratio * incoming[1] + bend * normal[1]
                picture.line(along(at, inside, (bottom - at[1]) / inside[1]), at, color, 1.3)
                picture.line(at, along(at, incoming, -(at[1] - 68) / incoming[1]), color, 1.3)
        x = 350 + math.copysign(270, slant)
        picture.eye((x, 44), math.pi / 2 + slant, 20, color)
    picture.span((left, bottom + 40), (left + pitch, bottom + 40), INK)
    picture.text((left + pitch / 2, bottom + 55), 'p', INK, 19)
    picture.span((left - 22, edge), (left - 22, bottom), INK)
    picture.text((left - 42, (edge + bottom) / 2), 'e', INK, 19)
    return picture


def nine_taps():
    """The nine texels, and depth along one axis with the two extrapolations."""
    picture = Drawing(700, 330)
    cell, grid = 42, (40, 60)
    for row in range(5):
        for column in range(5):
            on = row == 2 or column == 2
            picture.rect(grid[0] + column * cell, grid[1] + row * cell, cell, cell,
                         (SKY if row == 2 else '#ecebe6') if on else None, GRAY, 1)
            middle = grid[0] + (column + 0.5) * cell, grid[1] + (row + 0.5) * cell
            if on:
                k = column - 2 if row == 2 else 2 - row
                picture.circle(middle, 5 if k else 8, INK if k == 0 else BLUE if row == 2 else GRAY)
    for column in range(5):
        k = column - 2
        picture.text((grid[0] + (column + 0.5) * cell, grid[1] + 5 * cell + 18), str(k).replace('-', '−'), INK, 15, italic=False)

    left, step, zero = 345, 72, 290
    depth = {-2: 78, -1: 128, 0: 178, 1: 204, 2: 207}

    def place(k, z):
        return left + (k + 2) * step, zero - z

    picture.arrow((305, zero), (690, zero), GRAY, 1.3)
    picture.arrow((305, zero), (305, 30), GRAY, 1.3)
    picture.text((289, 38), 'z', GRAY, 19)
    for k in depth:
        picture.line(place(k, 0), place(k, -6), GRAY, 1.3)
        picture.text(place(k, -20), str(k).replace('-', '−'), INK, 15, italic=False)
    guess = 2 * depth[1] - depth[2]
    picture.shape([place(-2.35, depth[-2] - 17.5), place(-2.35, 0), place(0.4, 0), place(0.4, 198)], SKY)
    picture.line(place(-2.35, depth[-2] - 17.5), place(0.4, 198), BLUE, 4)
    picture.shape([place(0.4, 0), place(0.4, 202.2), place(2.45, 208.4), place(2.45, 0)], PEACH)
    picture.line(place(0.4, 202.2), place(2.45, 208.4), ORANGE, 4)
    picture.line(place(0.4, 0), place(0.4, 202), GRAY, 1.2, '3,3')
    picture.line(place(-2, depth[-2]), place(0.9, depth[0] + 45), BLUE, 1.6, '6,4')
    picture.line(place(2, depth[2]), place(-0.75, 204 - 5.25), ORANGE, 1.6, '6,4')
    picture.circle(place(0, guess), 8, PAPER, ORANGE, 2.2)
    picture.circle(place(0, depth[0]), 10, PAPER, BLUE, 2.2)
    for k, z in depth.items():
        picture.circle(place(k, z), 5.5, INK if k == 0 else BLUE if k < 0 else ORANGE)
    picture.text((place(0, 0)[0] + 12, place(0, depth[0] - 24)[1]), 'z', INK, 19, 'start', below='0')
    picture.text((place(-1, 0)[0] + 8, place(0, depth[-1] - 20)[1]), 'z', BLUE, 19, 'start', below='−1')
    picture.text((place(-2, 0)[0] + 8, place(0, depth[-2] - 20)[1]), 'z', BLUE, 19, 'start', below='−2')
    picture.text((place(1, 0)[0] - 4, place(0, depth[1] - 22)[1]), 'z', ORANGE, 19, 'start', below='1')
    picture.text((place(2, 0)[0] - 4, place(0, depth[2] - 22)[1]), 'z', ORANGE, 19, 'start', below='2')
    picture.text((place(0, 0)[0] - 20, place(0, guess + 26)[1]), '2z₁ − z₂', ORANGE, 17)
    picture.text((place(-1, 0)[0] - 48, place(0, depth[0] + 2)[1]), '2z₋₁ − z₋₂', BLUE, 17)
    picture.arrow((place(-1, 0)[0] + 4, place(0, depth[0] + 1)[1]), (place(0, 0)[0] - 12, place(0, depth[0])[1]), BLUE, 1.2, 7)
    return picture


def penumbra():
    """A ray to the lamp that passes a ball at the distance h, t meters from where it began; and the light on the floor."""
    picture = Drawing(700, 360)
    floor, sharp = 268, 2.5
    ball, radius = (330, 112), 50
    direction = unit((0, 0), (0.78, -0.62))

    def ratio(x):
        """Returns the smallest h/t along the ray from (x, floor), with h and t where it is found; h < 0 is a hit."""
        best = (math.inf, 0, 0)
        t = 4.0
        while t < 700:
            p = along((x, floor), direction, t)
            h = math.dist(p, ball) - radius
            if h / t < best[0]:
                best = (h / t, h, t)
            t += 1.0
        return best

    def light(x):
        return max(0.0, min(1.0, sharp * ratio(x)[0]))

    # The floor, lit: a strip of short pieces, and the curve of the light over it.
    first, last, step = 30, 670, 8
    for k in range((last - first) // step):
        share = light(first + (k + 0.5) * step)
        dark, bright = (0x3c, 0x3f, 0x46), (0xf3, 0xdf, 0xa8)
        color = '#' + ''.join(f'{round(a + (b - a) * share):02x}' for a, b in zip(dark, bright))
        picture.rect(first + k * step, floor, step + 0.3, 16, color)
    picture.line((first, floor), (last, floor), INK, 2)
    low, high = 342, 298
    picture.line((first, low), (last, low), GRAY, 1.2)
    picture.line((first, high), (last, high), GRAY, 1.2, '4,4')
    picture.shape([(x, low - (low - high) * light(x)) for x in range(first, last + 1, 4)], None, INK, 2, None, False)
    picture.text((last + 14, low), '0', INK, 15, italic=False)
    picture.text((last + 14, high), '1', INK, 15, italic=False)

    # Lamp, ball, and the ray of one point in the half-shadow.
    x = next(x for x in range(last, first, -1) if light(x) < 0.62)
    p = x, floor
    _, h, t = ratio(x)
    nearest = along(p, direction, t)
    end = along(p, direction, (floor - 50) / -direction[1])
    angle = math.asin(h / t)
    heading = math.atan2(direction[1], direction[0])
    for side in (-1, 1):
        edge = math.cos(heading + side * angle), math.sin(heading + side * angle)
        picture.line(p, along(p, edge, math.sqrt(t * t - h * h) * 1.32), BLUE, 1.4, '6,4')
    picture.circle(nearest, h, SKY, BLUE, 1.6)
    picture.circle(ball, radius, PALE, INK, 2)
    picture.arrow(p, end, INK, 1.6, 12)
    picture.line(p, nearest, INK, 3.2)
    picture.circle((end[0] + 20, end[1] - 14), 17, '#f6cf62', '#b98a1b', 1.8)
    touched = along(ball, unit(ball, nearest), radius)
    picture.line(nearest, touched, ORANGE, 3)
    picture.circle(nearest, 5, INK)
    picture.circle(p, 6, INK)
    picture.text((p[0] - 18, p[1] - 16), 'p', INK, 20)
    picture.text(((nearest[0] + touched[0]) / 2 + 10, (nearest[1] + touched[1]) / 2 - 10), 'h', ORANGE, 21)
    middle = along(p, direction, 0.62 * t)
    picture.text((middle[0] + 9, middle[1] + 14), 't', INK, 21)
    return picture


DIAGRAMS = {'sphere_tracing': sphere_tracing, 'occlusion': occlusion, 'lens_views': lens_views, 'nine_taps': nine_taps,
            'penumbra': penumbra}


def main():
    stale = []
    for name, draw in DIAGRAMS.items():
        path = os.path.join(FOLDER, name + '.svg')
        made = draw().svg().encode('utf-8')
        if '--check' in sys.argv[1:]:
            with open(path, 'rb') as file:
                if file.read() != made:
                    stale.append(path)
        else:
            with open(path, 'wb') as file:
                file.write(made)
    for path in stale:
        print(f'{path} is not what diagrams.py draws; run python3 assets/pages/diagrams.py', file=sys.stderr)
    return 1 if stale else 0


if __name__ == '__main__':
    sys.exit(main())
