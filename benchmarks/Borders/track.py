"""Makes a track of a minute, and fits it from Python.

    track.py make FILE.csv       20 kicks, 50 rows per second, noise of 5 mm, wind of 3 m/s; t, x, y, z with z up, as football fit --match reads it
    track.py fit FILE.csv        fits it as a match, and prints the number of flights
"""

import sys

import numpy as np

import football_physics as fp


def make(file):
    random = np.random.default_rng(1)
    balls = fp.Balls(fp.Scene({"air": {"wind": [0, 0, 3]}}), 1)
    rows = []
    for kick in range(20):
        # Towards the middle of the pitch, so that the ball stays on it.
        x, _, z = balls.position[0]
        toward = np.arctan2(-x, -z) + random.normal(0, 0.4)
        speed, up = random.uniform(14, 26), np.radians(random.uniform(15, 40))
        balls.place(None, balls.position[0], speed * np.array([np.cos(up) * np.sin(toward), np.sin(up), np.cos(up) * np.cos(toward)]), random.normal(0, 30, 3))
        for tick in range(150):
            rows.append([3 * kick + tick / 50, *(balls.position[0] * [1, 1, -1])[[0, 2, 1]]])
            balls.step(1 / 50)
    rows = np.array(rows)
    rows[:, 1:] += random.normal(0, 0.005, (len(rows), 3))
    np.savetxt(file, rows, "%.4f", ",", header="t,x,y,z", comments="")


def fit(file):
    track = fp.track(np.genfromtxt(file, delimiter=",", names=True, dtype=None, encoding="utf-8"))
    found = fp.fit_match(fp.Scene(), track)
    print(len(track), "rows,", found.flights, "flights,", f"rms {found.rms:.3f} m, wind_z {found.values['wind_z']:.2f} m/s")


{"make": make, "fit": fit}[sys.argv[1]](sys.argv[2])
