# SPDX-License-Identifier: GPL-3.0-or-later
"""Clean-up of baked light: buried texels, noise, margins."""
import warnings

import numpy as np


def clean(light, covered, place, normal, tolerance=0.5):
    """light, place and normal are (n, n, 3); texels with no light at all lie inside other solids.

    tolerance: difference, as a fraction, that counts as noise rather than shade."""
    valid = covered & (light.max(axis=2) > 1e-6)
    valid &= ~_speck(valid, light)
    light = _calm(light, valid)
    for level in range(5):
        light = _smooth(light, valid, place, normal, 1 << level, tolerance / (1 << level))
    return fill(light, valid)


def _shift(a, dy, dx):
    return np.roll(a, (dy, dx), (0, 1))


def _speck(valid, light):
    """Texels at the rim of a buried part, which see only a sliver of the room."""
    level = light.mean(axis=2)
    total, count, dark = np.zeros_like(level), np.zeros_like(level), np.zeros(level.shape, bool)
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            v = _shift(valid, dy, dx)
            total += np.where(v, _shift(level, dy, dx), 0)
            count += v
            dark |= ~v
    return valid & dark & (level < 0.25 * total / np.maximum(count, 1))


def _calm(light, valid):
    """Cut outliers down to what their neighbors allow."""
    level = np.where(valid, light.mean(axis=2), np.nan)
    around = np.stack([_shift(level, dy, dx) for dy in (-2, -1, 0, 1, 2) for dx in (-2, -1, 0, 1, 2)])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        median = np.nanmedian(around, axis=0)
    limit = np.where(np.isfinite(median), 2.5 * median, np.inf)
    factor = np.where(valid & (level > limit), limit / np.maximum(level, 1e-9), 1.0)
    return light * factor[..., None].astype(np.float32)


def _smooth(light, valid, place, normal, step, tolerance, reach=0.075):
    """One level of an edge-stopping wavelet filter: only over texels near in space, facing alike and not
    much brighter or darker than this one's surroundings."""
    level = _blur(light.mean(axis=2), valid)
    kernel = (1 / 16, 1 / 4, 3 / 8, 1 / 4, 1 / 16)
    total, weight = np.zeros_like(light), np.zeros(valid.shape, np.float32)
    far = (reach * step * 2) ** 2
    for j in range(5):
        for i in range(5):
            dy, dx = (j - 2) * step, (i - 2) * step
            d2 = ((_shift(place, dy, dx) - place) ** 2).sum(axis=2)
            facing = np.clip((_shift(normal, dy, dx) * normal).sum(axis=2), 0, 1) ** 12
            near = _shift(level, dy, dx)
            ratio = np.abs(near - level) / np.maximum(tolerance * np.maximum(level, near), 1e-6)
            w = kernel[i] * kernel[j] * np.exp(-d2 / far) * facing * np.exp(-ratio) * _shift(valid, dy, dx)
            w = np.where(d2 < 4 * far, w, 0).astype(np.float32)
            total += _shift(light, dy, dx) * w[..., None]
            weight += w
    ok = valid & (weight > 1e-6)
    return np.where(ok[..., None], total / np.maximum(weight, 1e-9)[..., None], light).astype(np.float32)


def _blur(level, valid):
    total, count = np.zeros_like(level), np.zeros_like(level)
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            v = _shift(valid, dy, dx)
            total += np.where(v, _shift(level, dy, dx), 0)
            count += v
    return total / np.maximum(count, 1)


def fill(light, valid, rounds=16):
    """Spread into the texels that hold nothing."""
    out, have = np.where(valid[..., None], light, 0).astype(np.float32), valid.copy()
    for _ in range(rounds):
        total, count = np.zeros_like(out), np.zeros(have.shape, np.float32)
        for dy in (-1, 0, 1):
            for dx in (-1, 0, 1):
                w = _shift(have, dy, dx).astype(np.float32) * (1.0 if dx == 0 or dy == 0 else 0.5)
                total += _shift(out, dy, dx) * w[..., None]
                count += w
        new = ~have & (count > 0)
        out[new] = total[new] / count[new][:, None]
        have |= new
    out[~have] = np.median(light[valid], axis=0)
    return out
