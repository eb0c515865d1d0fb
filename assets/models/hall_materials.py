# SPDX-License-Identifier: GPL-3.0-or-later
"""What the hall is made of: mean linear albedo (or metal reflectance), roughness, metalness, tile in meters.

A tile size means that textures.py paints color, normal and occlusion-roughness-metalness maps; what is polished is
flat and has no normals."""

MATERIALS = {
    "terrazzo":   {"color": (0.50, 0.465, 0.42),  "roughness": 0.145, "metalness": 0.0, "tile": 2.0,
                   "polished": True},
    "plaster":    {"color": (0.72, 0.68, 0.61),   "roughness": 0.88, "metalness": 0.0, "tile": 3.0},
    "dado":       {"color": (0.175, 0.17, 0.14), "roughness": 0.55, "metalness": 0.0, "tile": 1.5},
    "coffer":     {"color": (0.70, 0.67, 0.61),   "roughness": 0.85, "metalness": 0.0},
    "travertine": {"color": (0.535, 0.475, 0.4),  "roughness": 0.45, "metalness": 0.0, "tile": 1.1},
    "bronze":     {"color": (0.36, 0.235, 0.125), "roughness": 0.36, "metalness": 1.0},
    "brass":      {"color": (0.78, 0.56, 0.27),   "roughness": 0.24, "metalness": 1.0},
    "oak":        {"color": (0.27, 0.155, 0.075), "roughness": 0.48, "metalness": 0.0, "tile": 1.2},
    "leather":    {"color": (0.19, 0.078, 0.034), "roughness": 0.45, "metalness": 0.0, "tile": 0.6},
    "dark":       {"color": (0.02, 0.02, 0.021),  "roughness": 0.80, "metalness": 0.0},
    "cloth":      {"color": (0.40, 0.39, 0.375),  "roughness": 0.95, "metalness": 0.0, "tile": 0.4},
    "banner":     {"color": (0.36, 0.055, 0.04),  "roughness": 0.90, "metalness": 0.0},
}
