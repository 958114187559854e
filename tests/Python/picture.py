"""Checks the pictures of samples/Love and samples/Pygame: the same kick, seen by the same camera, just after the goal.

    picture.py FILE.png ...     one line for each picture; exit code 1 if a part is missing
"""

import os
import sys

os.environ["PYGAME_HIDE_SUPPORT_PROMPT"] = "1"
import numpy as np  # noqa: E402
import pygame  # noqa: E402

WHITE, GRASS, SHIRT, PATH = (250, 250, 250), (69, 148, 65), (204, 36, 51), (255, 237, 102)
# A part, its colour, the rectangle that contains it (left, top, right, bottom), and the least share of that colour in it.
PARTS = [
    ("grass", GRASS, (0, 275, 960, 540), 0.5),
    ("left post", WHITE, (285, 200, 289, 295), 0.9),
    ("right post", WHITE, (629, 200, 632, 275), 0.9),
    ("bar", WHITE, (300, 182, 480, 186), 0.9),
    ("wall", SHIRT, (395, 313, 685, 380), 0.8),
    ("path before the wall", PATH, (350, 400, 420, 540), 0.01),
    ("path to the goal", PATH, (540, 175, 595, 225), 0.01),
    ("ball", WHITE, (594, 224, 602, 232), 0.3),
]
for file in sys.argv[1:]:
    pixels = pygame.surfarray.array3d(pygame.image.load(file)).astype(int)
    if pixels.shape != (960, 540, 3):
        sys.exit(f"{file} is {pixels.shape[0]} x {pixels.shape[1]} pixels; expected: 960 x 540")
    for part, color, (left, top, right, bottom), least in PARTS:
        share = (np.abs(pixels[left:right, top:bottom] - color).sum(axis=2) < 36).mean()
        if share < least:
            sys.exit(f"{file}: {share:.0%} of the {part} has its colour; expected: at least {least:.0%}")
    print(f"{os.path.basename(file)}: {', '.join(part for part, *_ in PARTS)}")
