namespace FootballPhysics.Passes.Plays;

/// <summary>A ball among 22 moving players, on a pitch with boards: each player runs towards the ball or about, and plays the ball if it stops.</summary>
internal static class Crowd
{
    private const double Frame = 1.0 / 60;

    public static void Play()
    {
        foreach ((Pitch pitch, int seed) in new[] { (Pitch.Stadium, 3), (Pitch.Cage, 4), (Pitch.Futsal with { BoardHeight = 1, BoardDistance = 1 }, 5) })
        {
            Match(new Draw(seed), pitch, Scene.Default, 120);
        }

        Match(new Draw(6), Pitch.Cage, Scene.Published, 20);
        Match(new Draw(7), Pitch.Cage, Scene.Windy(new Vector3d(5, 0, 1)), 20);
    }

    private static void Match(Draw draw, Pitch pitch, Scene scene, double seconds)
    {
        var bodies = new KinematicBodies();
        var players = new Runner[22];
        double width = (pitch.Width / 2) - 1;
        double length = (pitch.Length / 2) - 1;
        for (int i = 0; i < players.Length; i++)
        {
            KinematicBody body = i % 7 == 6 ? bodies.Add("boot", BodyKind.Boot) : i % 7 == 5 ? bodies.Add("head", BodyKind.Head) : bodies.Add($"player {i}", BodyKind.Player);
            players[i] = new Runner(body, new Vector3d(draw.Between(-width, width), 0, draw.Between(-length, length)));
        }

        var ball = new Ball(new Simulator(pitch.On(scene) with { Bodies = bodies }));
        ball.Place(new Vector3d(0, 0.11, 0));
        double stopped = 0;
        while (ball.Time < seconds)
        {
            foreach (Runner player in players)
            {
                player.Move(draw, ball.State, Frame, ball.Time, width, length);
            }

            Vector3d at = ball.State.Position;
            stopped = ball.State.Velocity.Length < 0.3 ? stopped + Frame : 0;
            if (Math.Abs(at.X) > width + 8 || Math.Abs(at.Z) > length + 8)
            {
                ball.Place(new Vector3d(draw.Between(-width, width), 0.11, draw.Between(-length, length)));
            }
            else if (stopped > 1.5 || draw.Chance(0.002))
            {
                (Vector3d velocity, Vector3d spin) = draw.Kick();
                ball.Kick(velocity, spin);
                stopped = 0;
            }

            ball.Step(Frame);
        }
    }

    private sealed class Runner(KinematicBody body, Vector3d place)
    {
        private Vector3d _place = place;
        private Vector3d _heading = new(1, 0, 0);
        private double _speed;
        private double _turn;

        public void Move(Draw draw, in BallState ball, double frame, double time, double width, double length)
        {
            if (draw.Chance(0.02))
            {
                Vector3d towards = ball.Position - _place;
                towards = new Vector3d(towards.X, 0, towards.Z);
                _heading = draw.Chance(0.6) && towards.Length > 0.01 ? towards.Normalized() : draw.Heading();
                _speed = draw.Any(0, 1, 3, 6, 8.5);
                _turn = draw.Chance(0.3) ? draw.Between(-6, 6) : 0;
                if (draw.Chance(0.05))
                {
                    body.Withdraw();
                    return;
                }
            }

            Vector3d velocity = _speed * _heading;
            Vector3d next = _place + (frame * velocity);
            if (Math.Abs(next.X) > width + 2 || Math.Abs(next.Z) > length + 2)
            {
                velocity = default;
                next = _place;
            }

            double lift = body.Name == "head" ? 1.2 : 0;
            body.MoveTo(_place + new Vector3d(0, lift, 0), Quaterniond.FromAxisAngle(Vector3d.Up, _turn * time), velocity, new Vector3d(0, _turn, 0), time);
            _place = next;
        }
    }
}
