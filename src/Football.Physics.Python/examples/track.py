"""From the track of a camera to launches, a fitted ball, and a picture.

    python3 track.py [TRACK.csv]        a header, and lines t, x, y, z in s and m, with z up; default: makes a track of its own, of three kicks in a wind

Prints the kicks and what was fitted, and draws track.svg: the track from above as dots, the fitted flights as lines.
"""

import sys

import numpy as np

import football_physics as fp


def make_track(file):
    """Three kicks from where the ball is, in a wind of 3 m/s, with 1 cm of noise and 50 rows a second."""
    scene, noise = fp.Scene({"air": {"wind": [0, 0, 3]}}), np.random.default_rng(3)
    balls, rows, start = fp.Balls(scene, 1, [0, 0.11, 40]), [], 0.0
    for velocity, spin in (([3, 11, -20], [0, 30, 0]), ([-4, 9, -14], [0, -40, 0]), ([5, 12, 19], [0, 0, 0])):
        balls.place(None, balls.position[0], velocity, spin)
        for tick in range(150):
            rows.append([start + tick / 50, *(balls.position[0] * [1, 1, -1])[[0, 2, 1]]])
            balls.step(1 / 50)
        start += 3.0
    rows = np.array(rows)
    rows[:, 1:] += noise.normal(0, 0.01, (len(rows), 3))
    np.savetxt(file, rows, "%.4f", ",", header="t,x,y,z", comments="")


file = sys.argv[1] if len(sys.argv) > 1 else "track.csv"
if len(sys.argv) < 2:
    make_track(file)
track = fp.track(np.genfromtxt(file, delimiter=",", names=True, dtype=None, encoding="utf-8"))
found = fp.fit_match(fp.Scene(), track)

print(f"{len(track)} rows, {found.noise:.3f} m of noise; {found.flights} flights, {found.rms:.3f} m off")
for name, value in found.values.items():
    print(f"{name:>24} {value:10.4g} +- {found.deviations[name]:.2g}")
for piece in found.pieces:
    speed, spin = np.linalg.norm(piece["velocity"]), np.linalg.norm(piece["spin"])
    if piece["kind"] == fp.PieceKind.TOUCH or (piece["kind"] == fp.PieceKind.FLIGHT and piece["start_time"] == found.pieces["start_time"][0]):
        elevation = np.degrees(np.arcsin(piece["velocity"][1] / max(speed, 1e-9)))
        print(f"kick after {piece['start_time']:6.2f} s: {speed:4.1f} m/s, {elevation:3.0f} degrees up, spin {spin:3.0f} rad/s")

# From above: x to the right, z down, m.
low, high = track[:, [1, 3]].min(0) - 3, track[:, [1, 3]].max(0) + 3
lines = [
    f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{low[0]:.2f} {low[1]:.2f} {high[0] - low[0]:.2f} {high[1] - low[1]:.2f}">',
    f'<rect x="{low[0]:.2f}" y="{low[1]:.2f}" width="100%" height="100%" fill="#3c8c3c"/>']
lines += [f'<circle cx="{x:.2f}" cy="{z:.2f}" r="0.12" fill="#fff"/>' for _, x, _, z in track]
for flight in found.pieces[found.pieces["kind"] == fp.PieceKind.FLIGHT]:
    # The fitted launch, played in the fitted scene.
    balls = fp.Balls(found.scene, 1)
    balls.place(None, flight["position"], flight["velocity"], flight["spin"])
    path = balls.look_ahead(max(flight["end_time"] - flight["start_time"], 0.02), 0.02)[0]
    points = " ".join(f"{x:.2f},{z:.2f}" for _, x, _, z in path)
    lines.append(f'<polyline points="{points}" fill="none" stroke="#c22" stroke-width="0.25"/>')
with open("track.svg", "w", encoding="utf-8") as picture:
    picture.write("\n".join(lines) + "\n</svg>\n")
