"""A free kick over a wall with pygame and the Python package. Aim with the mouse. A and D change the sidespin, W and S the topspin.
Hold the mouse button for power, and release it to kick. R resets the ball. Needs the wheel of football_physics and Debian's python3-pygame.

    python3 samples/Pygame/free_kick.py                        play
    python3 samples/Pygame/free_kick.py --picture FILE.png     kick once without a window, write a picture and print: Goal! hash 44123208c9f0f689
"""

import os
import sys

import football_physics as fp

PICTURE = sys.argv[2] if len(sys.argv) == 3 and sys.argv[1] == "--picture" else None
if PICTURE:
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
import pygame  # noqa: E402

# The picture is drawn at twice the size of the window and scaled down, which makes edges smooth.
STEP, SPOT, GOAL, WALL, WIDTH, HEIGHT, FOCAL, HORIZON, WHITE, INK = 1 / 60, (0.0, 0.11, 0.0), -22.0, -9.15, 1920, 1080, 2000, 340, (250, 250, 250), (20, 26, 51)
SCENE = {"goals": [{"center": [0, 0, GOAL], "facing": [0, 0, 1]}],
         "obstacles": [{"name": "wall", "shape": "box", "center": [1, 0.92, WALL], "halfSize": [1.3, 0.92, 0.2]}]}


class Game:
    """The ball, its path and the player's choices."""

    def __init__(self):
        self.balls, self.target, self.side, self.top, self.goals, self.kicks = fp.Balls(fp.Scene(SCENE), 1, SPOT), [2.9, 1.7, GOAL], -45, 0, 0, 0
        self.place()

    def place(self):
        self.balls.place(None, SPOT)
        self.ball, self.path, self.flying, self.text = SPOT, [SPOT], False, "Aim, hold for power, let go to kick."

    def kick(self, speed):
        aim = self.balls.aim(self.target, speed, spin={"side": self.side, "top": self.top})
        self.balls.kick(None, aim.velocity, aim.spin)
        self.flying, self.kicks, self.text = True, self.kicks + 1, f"{3.6 * speed:.0f} km/h"

    def step(self):
        for event in self.balls.step_events(STEP):
            name = self.balls.scene.name_of(int(event["thing"]))
            if event["kind"] == fp.EventKind.GOAL:
                self.goals, self.text = self.goals + 1, "Goal!"
            elif event["kind"] == fp.EventKind.IMPACT and name != "ground":
                self.text = f"Hit the {name}."
        self.ball = tuple(self.balls.position[0].tolist())
        if self.flying and self.ball[2] > GOAL - 2 and len(self.path) < 100:
            self.path.append(self.ball)


class Camera:
    """Draws what the kicker sees; points are x, y, z in metres."""

    def __init__(self):
        self.canvas, self.font, self.eye = pygame.Surface((WIDTH, HEIGHT)), pygame.font.Font(None, 52), (0, 0)

    def seen(self, x, y, z):  # the pixel of a point, and the pixels of a metre there
        scale = FOCAL / max(0.5, self.eye[1] - z)
        return WIDTH / 2 + scale * (x - self.eye[0]), HORIZON - scale * (y - 2.8), scale

    def line(self, color, width, *points):
        pygame.draw.lines(self.canvas, color, False, [self.seen(*point)[:2] for point in points], width)

    def box(self, color, z, x1, x2, y1, y2):
        (left, top, _), (right, bottom, _) = self.seen(x1, y2, z), self.seen(x2, y1, z)
        pygame.draw.rect(self.canvas, color, (left, top, right - left + 1, bottom - top + 1))

    def disc(self, color, x, y, z, radius, flat=1.0):
        u, v, scale = self.seen(x, y, z)
        pygame.draw.ellipse(self.canvas, color, (u - radius * scale, v - radius * scale * flat, 2 * radius * scale, 2 * radius * scale * flat))

    def draw(self, screen, game, power):
        ball_x, ball_y, ball_z = game.ball
        self.eye = 0.15 * ball_x, 8.5 + 0.4 * max(GOAL, ball_z)
        self.canvas.fill((140, 189, 235))
        self.box((41, 48, 69), -34, -50, 50, 0, 7)
        for i in range(630):  # the crowd
            self.disc((90 + i * i % 5 * 33, 76 + i * i % 7 * 20, 90 + i * i % 11 * 12), -23 + i // 9 * 0.66 + i * 0.37 % 0.4, 1.5 + i % 9 * 0.6 + i * 0.37 % 0.2, -34, 0.13)
        for x in range(-36, 36, 6):
            self.box((26, 76, 153) if x % 12 == 0 else (242, 191, 51), -28, x, x + 6, 0, 0.9)
        for z in range(-28, 8, 4):
            self.canvas.fill((64, 140, 61) if z % 8 == 0 else (74, 155, 69), (0, self.seen(0, 0, z)[1], WIDTH, HEIGHT))
        for half, z, width in (40, GOAL, 3), (9.16, -16.5, 4), (40, -5.5, 7):
            self.line(WHITE, width, (-half, 0, z), (half, 0, z))
        for x in [-3.72 + 0.372 * i for i in range(21)]:
            self.line((200, 205, 215), 1, (x, 2.5, GOAL), (x, 2.5, GOAL - 0.8), (x, 0, GOAL - 2))
        for y in [0.3125 * i for i in range(9)]:
            back = GOAL - 2 + 0.48 * y
            self.line((200, 205, 215), 1, (-3.72, y, GOAL), (-3.72, y, back), (3.72, y, back), (3.72, y, GOAL))
        for x1, x2, y1, y2 in (-3.78, -3.66, 0, 2.56), (3.66, 3.78, 0, 2.56), (-3.78, 3.78, 2.44, 2.56):
            self.box(WHITE, GOAL, x1, x2, y1, y2)
        for layer in ("ball", "wall") if ball_z < WALL else ("wall", "ball"):
            for x in [-0.04 + 0.52 * i for i in range(5)] if layer == "wall" else []:
                self.disc((25, 90, 25), x, 0, WALL, 0.32, 0.15)
                self.box(WHITE, WALL, x - 0.18, x - 0.04, 0, 0.62)
                self.box(WHITE, WALL, x + 0.04, x + 0.18, 0, 0.62)
                self.box((31, 36, 77), WALL, x - 0.21, x + 0.21, 0.52, 0.98)
                self.box((204, 36, 51), WALL, x - 0.24, x + 0.24, 0.92, 1.55)
                self.disc((64, 41, 26), x, 1.71, WALL, 0.13)
                self.disc((230, 178, 140), x, 1.67, WALL, 0.11)
            if layer == "ball":
                self.disc((25, 90, 25), ball_x, 0, ball_z, 0.13, 0.25)
                self.disc(WHITE, ball_x, ball_y, ball_z, 0.11)
        if game.flying:
            self.line((255, 237, 102), 4, *game.path)
        else:
            self.disc((255, 80, 60), *game.target, 0.15)
        text = f"{game.text}    Goals: {game.goals} of {game.kicks}    Sidespin {game.side}, topspin {game.top} rad/s"
        self.canvas.blit(self.font.render(text, True, INK), (32, 24))
        pygame.draw.rect(self.canvas, INK, (1560, 28, 20 * (power - 16), 24))
        pygame.transform.smoothscale(self.canvas, screen.get_size(), screen)


def main():
    pygame.display.init()
    pygame.font.init()
    screen, game, camera, clock, held, left = pygame.display.set_mode((WIDTH // 2, HEIGHT // 2)), Game(), Camera(), pygame.time.Clock(), None, 0
    if PICTURE:
        game.kick(24)
    for tick in range(240 if PICTURE else sys.maxsize):
        power = 16 + 16 * min(1.0, (pygame.time.get_ticks() - held) / 1000 if held else 0.5)
        for event in pygame.event.get():
            if event.type == pygame.QUIT:
                return
            if event.type == pygame.MOUSEMOTION:
                game.target = [(event.pos[0] - 480) * 0.0305, max(0.11, 2.8 - (event.pos[1] - 170) * 0.0305), GOAL]
            if event.type == pygame.MOUSEBUTTONDOWN or (event.type == pygame.KEYDOWN and event.key == pygame.K_r):
                game.place()
                held = pygame.time.get_ticks() if event.type == pygame.MOUSEBUTTONDOWN else None
            if event.type == pygame.MOUSEBUTTONUP and held:
                game.kick(power)
                held = None
        keys = pygame.key.get_pressed()
        game.side, game.top = game.side + keys[pygame.K_a] - keys[pygame.K_d], game.top + keys[pygame.K_w] - keys[pygame.K_s]
        left += STEP if PICTURE else min(clock.tick(60) / 1000, 0.1)
        while left >= STEP:
            game.step()
            left -= STEP
        if not PICTURE or tick == 72:
            camera.draw(screen, game, power)
            pygame.display.flip()
        if PICTURE and tick == 72:
            pygame.image.save(screen, PICTURE)
    print(f"{game.text} hash {int(game.balls.hashes[0]):016x}")


if __name__ == "__main__":
    main()
