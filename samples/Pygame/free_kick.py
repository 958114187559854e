"""A free kick over a wall with pygame: hold the mouse where the ball is to go, let go to kick; the right button bends it to the left. R puts the ball back.

    python3 samples/Pygame/free_kick.py                        play
    python3 samples/Pygame/free_kick.py --picture FILE.png     kick once without a window, write a picture and print: Goal! hash 7b60d73cd435b0bf
Needs the wheel of football_physics and Debian's python3-pygame.
"""

import os
import sys

import football_physics as fp

PICTURE = sys.argv[2] if len(sys.argv) == 3 and sys.argv[1] == "--picture" else None
if PICTURE:
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
import pygame  # noqa: E402

WIDTH, HEIGHT, FOCAL = 960, 540, 1100
EYE = (0.0, 2.2, 9.0)
STEP = 1 / 60
SPOT = (0.0, 0.11, 0.0)
GOAL = 22.0
SCENE = {
    "goals": [{"center": [0, 0, -GOAL], "facing": [0, 0, 1]}],
    "obstacles": [{"name": "wall", "shape": "box", "center": [1, 0.92, -9.15], "halfSize": [1.3, 0.92, 0.2]}],
}


def seen(point):
    """The pixel at which a point is seen, and the pixels of a metre there."""
    scale = FOCAL / max(0.1, EYE[2] - point[2])
    return (WIDTH / 2 + scale * (point[0] - EYE[0]), HEIGHT * 0.45 - scale * (point[1] - EYE[1])), scale


def pointed(pixel):
    """The point in the goal's plane at which a pixel points."""
    scale = FOCAL / (EYE[2] + GOAL)
    return [(pixel[0] - WIDTH / 2) / scale + EYE[0], max(0.11, EYE[1] - (pixel[1] - HEIGHT * 0.45) / scale), -GOAL]


class Game:
    """The ball, its path and what it hit."""

    def __init__(self):
        self.balls = fp.Balls(fp.Scene(SCENE), 1, SPOT)
        self.path, self.text, self.goals = [], "Hold the mouse where the ball is to go.", 0

    def kick(self, target, speed, side):
        """Kicks the ball so that it passes the target."""
        self.balls.place(None, SPOT)
        aim = self.balls.aim(target, speed, spin={"side": side})
        self.balls.kick(None, aim.velocity, aim.spin)
        self.path, self.text = [], f"{speed:.0f} m/s"

    def step(self):
        """Advances the ball by a step."""
        for event in self.balls.step_events(STEP):
            name = self.balls.scene.name_of(int(event["thing"]))
            if event["kind"] == fp.EventKind.GOAL:
                self.goals += 1
                self.text = "Goal!"
            elif event["kind"] == fp.EventKind.IMPACT and name != "ground":
                self.text = f"Hit the {name}."
        if self.balls.motion[0] != fp.Motion.STOPPED:
            self.path.append(tuple(self.balls.position[0]))

    def draw(self, screen, font, pull):
        """Draws what the kicker sees."""
        screen.fill((150, 190, 230))
        horizon = HEIGHT * 0.45
        pygame.draw.rect(screen, (70, 130, 60), (0, horizon, WIDTH, HEIGHT - horizon))
        frame = [seen((x, y, -GOAL))[0] for x, y in ((-3.72, 0), (-3.72, 2.5), (3.72, 2.5), (3.72, 0))]
        pygame.draw.lines(screen, (250, 250, 250), False, frame, 5)
        pygame.draw.line(screen, (220, 230, 220), frame[0], frame[3], 1)
        ball_first = self.balls.position[0][2] < -9.15
        if ball_first:
            self.draw_ball(screen)
        for i in range(5):
            (x, y), scale = seen((-0.3 + 0.52 * i + 0.26, 1.84, -9.15))
            pygame.draw.rect(screen, (170, 40, 50), (x - 0.24 * scale, y, 0.48 * scale, 1.84 * scale), border_radius=int(0.2 * scale))
        if len(self.path) > 1:
            pygame.draw.lines(screen, (255, 240, 120), False, [seen(point)[0] for point in self.path], 2)
        if not ball_first:
            self.draw_ball(screen)
        if pull:
            pygame.draw.circle(screen, (255, 80, 60), pull[0], 10, 2)
        screen.blit(font.render(f"{self.text}   Goals: {self.goals}", True, (20, 30, 40)), (16, 12))

    def draw_ball(self, screen):
        """Draws the ball and its shadow."""
        x, y, z = self.balls.position[0]
        (u, v), scale = seen((x, 0, z))
        pygame.draw.ellipse(screen, (50, 100, 45), (u - 0.11 * scale, v - 0.03 * scale, 0.22 * scale, 0.06 * scale))
        pygame.draw.circle(screen, (255, 255, 255), seen((x, y, z))[0], max(2, 0.11 * scale))


def main():
    """Plays, or takes a picture of one kick."""
    pygame.display.init()
    pygame.font.init()
    screen, font, game = pygame.display.set_mode((WIDTH, HEIGHT)), pygame.font.Font(None, 32), Game()
    if PICTURE:
        game.kick([2.9, 1.7, -GOAL], 24, -45)
        for _ in range(240):
            game.step()
        game.draw(screen, font, None)
        pygame.image.save(screen, PICTURE)
        print(f"{game.text} hash {int(game.balls.hashes[0]):016x}")
        return
    clock, held = pygame.time.Clock(), None
    while True:
        for event in pygame.event.get():
            if event.type == pygame.QUIT:
                return
            if event.type == pygame.KEYDOWN and event.key == pygame.K_r:
                game.balls.place(None, SPOT)
                game.path = []
            if event.type == pygame.MOUSEBUTTONDOWN and event.button in (1, 3):
                held = (event.button, pygame.time.get_ticks())
            if event.type == pygame.MOUSEBUTTONUP and held and event.button == held[0]:
                share = min(1.0, (pygame.time.get_ticks() - held[1]) / 1000)
                game.kick(pointed(event.pos), 16 + 16 * share, 55 if held[0] == 3 else 0)
                held = None
        game.step()
        game.draw(screen, font, (pygame.mouse.get_pos(), held) if held else None)
        pygame.display.flip()
        clock.tick(60)


if __name__ == "__main__":
    main()
