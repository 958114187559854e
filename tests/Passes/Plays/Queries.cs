using FootballPhysics.Aiming;
using FootballPhysics.Prediction;
using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>Questions of a game's players: where the ball will be, how to kick it to a target, who reaches it first, how to touch it.</summary>
internal static class Queries
{
    public static void Play()
    {
        var draw = new Draw(15);
        LooksAhead(draw);
        Aims(draw);
        Banks(draw);
        Touch(draw);
        Interceptions(draw);
    }

    private static void LooksAhead(Draw draw)
    {
        var bodies = new KinematicBodies();
        KinematicBody post = bodies.Add("runner", BodyKind.Player);
        Scene[] scenes = [Scene.Default, Pitch.Standard.On(), Pitch.Cage.On(), Scene.Published, Scene.Vacuum, Scene.Default with { Bodies = bodies }, new Scene { Forces = ForceSet.Measured with { CustomForces = [Laws.IForce.From(ball => -0.1 * ball.Velocity)] } }];
        foreach (Scene scene in scenes)
        {
            var simulator = new Simulator(scene);
            var path = new Trajectory(new PathSegment[draw.Any(16, 512)]);
            var run = new LookAheadRun(simulator);
            var cache = new TrajectoryCache(simulator, new LookAheadRequest { Duration = 4 });
            for (int i = 0; i < 12; i++)
            {
                (Vector3d velocity, Vector3d spin) = draw.Kick();
                BallState ball = simulator.Launch(new Vector3d(draw.Between(-5, 5), 0.11, draw.Between(-40, 40)), velocity, spin);
                var request = new LookAheadRequest
                {
                    Duration = draw.Between(1, 8),
                    TimeStep = draw.Any(1.0 / 60, 0.02),
                    StopAt = draw.Any(StopAt.Rest, StopAt.Time, StopAt.Impact),
                    UntilPlane = draw.Chance(0.3) ? new Plane3d(new Vector3d(0, 0, draw.Between(-20, 20)), new Vector3d(0, 0, 1)) : null,
                    UntilPassing = draw.Chance(0.3) ? draw.Vector(10) : null,
                    MoveBodies = scene.Bodies is null ? null : time => post.MoveTo(new Vector3d(time, 0, 2), new Vector3d(1, 0, 0), time),
                };
                _ = request.UntilPlane?.ToString();
                simulator.LookAhead(in ball, request, path);
                Read(draw, path);
                run.Start(in ball, request);
                var log = new StepLog();
                while (!run.Continue(30))
                {
                    simulator.Step(ref ball, 0.01, log);
                    _ = run.Follows(in ball);
                }

                Read(draw, run.Path);
                if (i % 4 == 3)
                {
                    run.Start(in ball, request);
                    run.Continue(3);
                    run.Cancel();
                }

                for (int step = 0; step < 20; step++)
                {
                    cache.Update(in ball);
                    simulator.Step(ref ball, 0.02, log);
                }

                cache.Invalidate();
            }
        }

        var group = new BallGroup(new Simulator(Pitch.Cage.On()), 3);
        var runs = new LookAheadRun(group);
        for (int i = 0; i < 10; i++)
        {
            BallState[] states = [.. Enumerable.Range(0, 3).Select(at => group.SimulatorOf(at).Launch(new Vector3d(0.4 * at, 0.3, 0), draw.Vector(8), default))];
            Trajectory[] paths = [new(), new(), new()];
            group.LookAhead(states, new LookAheadRequest { Duration = 3 }, paths);
            runs.Start(states, new LookAheadRequest { Duration = 3, StopAt = draw.Any(StopAt.Rest, StopAt.Impact) });
            while (!runs.Continue(3))
            {
                _ = runs.Follows(1, in states[1]);
            }

            Read(draw, runs.Paths[0]);
            runs.Start(states, new LookAheadRequest { Duration = 3 });
            runs.Cancel();
        }
    }

    private static void Read(Draw draw, Trajectory path)
    {
        _ = path.ToString();
        _ = path.ApexPoint().ToString();
        _ = path.TryGetTouchdown(0, out _) | path.TryGetRest(out _) | path.TryGetHit(0, out _);
        _ = path.TryGetCrossing(new Plane3d(new Vector3d(0, 0, draw.Between(-9, 9)), draw.Heading()), out PathPoint crossing);
        _ = crossing.ToString();
        _ = path.ClosestApproach(draw.Vector(9));
        _ = path.ClosestApproach(draw.Vector(9), draw.Vector(9));
        var places = new Vector3d[50];
        _ = path.Sample(places, 0.05);
        double time = Math.Min(path.StartTime + draw.Between(0, 0.9), path.EndTime);
        _ = path.PositionAt(time) + path.VelocityAt(time);
        _ = path.Apex + path.HangTime + path.Carry + path.Evaluations;
        foreach (ref readonly PathSegment piece in path.Pieces)
        {
            _ = piece.PositionAt(piece.Time) + piece.VelocityAt(piece.EndTime) + new Vector3d(piece.Apex, 0, (int)piece.Motion);
        }
    }

    private static void Aims(Draw draw)
    {
        Scene[] scenes =
        [
            Scene.Default, Scene.Published, Scene.Windy(new Vector3d(6, 0, 3)), Pitch.Standard.On(), Scene.HighAltitude, Scene.Vacuum,
            Scene.Default with { Ground = new Ground { Normal = new Vector3d(0.08, 1, 0).Normalized() } }, Scene.Default with { Ground = Slopes.Bowl() },
            Scene.Default with { Air = new Air { WindField = new Laws.WindByHeight(8, 1, 0.5, gusts: new Laws.Gusts { Seed = 2 }) }, Forces = ForceSet.Measured with { KnuckleSeed = 4 } },
        ];
        foreach (Scene scene in scenes)
        {
            var aimer = new Aimer(scene);
            aimer.WarmUp();
            bool level = scene.Ground.IsLevel;
            for (int i = 0; i < (level ? 26 : 6); i++)
            {
                var request = new AimRequest
                {
                    From = new Vector3d(0, draw.Any(0.11, 1.0), 0),
                    Target = (draw.Between(0.5, draw.Any(5, 60)) * draw.Heading()) + new Vector3d(0, draw.Any(0.11, 1.5, 8), 0),
                    Speed = draw.Any(8, 15, 28),
                    Arc = draw.Any(AimArc.Low, AimArc.High),
                    TopSpin = draw.Any(0, 20, -30),
                    SideSpin = draw.Any(0, 40),
                    Tolerance = draw.Any(0.001, 0.05),
                };
                request = draw.Below(5) switch
                {
                    0 => request with { SpinIsFree = true, Waypoint = 0.5 * request.Target + new Vector3d(draw.Between(-2, 2), 2, draw.Between(-2, 2)), WaypointTolerance = 0.3 },
                    1 => request with { TargetVelocity = draw.Between(0, 6) * draw.Heading() },
                    2 => request with { MinimumElevationDegrees = 5, MaximumElevationDegrees = 60 },
                    _ => request,
                };
                Attempt(() => aimer.Find(request, draw.Chance(0.8)).ToString("0.0"));
                if (request.Waypoint is null)
                {
                    Attempt(() => aimer.FindSlowest(request).ToString());
                    Attempt(() => aimer.FindAtTime(request, draw.Between(0.4, 3)).ToString());
                    Attempt(() => aimer.FindAtSpeed(request, draw.Between(2, 12)).ToString());
                }
            }
        }

        // Players in the way.
        Obstacle[] wall = [.. Enumerable.Range(0, 4).Select(i => new Obstacle { Name = $"wall {i}", Shape = new CapsuleShape(new Vector3d((0.5 * i) - 0.75, 0.2, 9), new Vector3d((0.5 * i) - 0.75, 1.6, 9), 0.25) })];
        var blocked = new Aimer(Scene.Default with { Obstacles = wall });
        for (int i = 0; i < 30; i++)
        {
            var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(draw.Between(-3, 3), draw.Between(0.3, 2.3), 20), Speed = draw.Between(12, 30), SpinIsFree = draw.Chance(0.3), Waypoint = draw.Chance(0.3) ? new Vector3d(draw.Between(-2, 2), 2.3, 9) : null };
            Attempt(() => blocked.Find(request).ToString());
        }
    }

    private static void Banks(Draw draw)
    {
        foreach (Scene scene in new[] { Pitch.Cage.On(), Pitch.Stadium.On(), Pitch.Cage.On(Scene.Windy(new Vector3d(3, 0, 0))) })
        {
            var aimer = new BankShotAimer(scene);
            for (int i = 0; i < 8; i++)
            {
                var request = new AimRequest { From = new Vector3d(draw.Between(-5, 5), 0.11, draw.Between(-5, 5)), Target = new Vector3d(draw.Between(-5, 5), 0.5, draw.Between(-5, 5)), Speed = draw.Between(8, 25) };
                Attempt(() => aimer.Find(request, scene.Obstacles[draw.Below(scene.Obstacles.Count)].Name).ToString());
                Attempt(() => aimer.Find(request, "ground").ToString());
                Attempt(() => aimer.Find(request, scene.Obstacles[0].Name, scene.Obstacles[^1].Name).ToString());
            }
        }
    }

    private static void Touch(Draw draw)
    {
        foreach (Scene scene in new[] { Scene.Default, Pitch.Standard.On(), Scene.Windy(new Vector3d(4, 0, 0)) })
        {
            var simulator = new Simulator(scene);
            foreach (Touches touches in new[] { new Touches(scene), new Touches(scene, new Foot { MaximumSpeed = 12 }, new TouchSpread { Draws = 40, SpeedPercent = 8, DirectionDegrees = 5, Contact = 0.01 }) })
            {
                for (int i = 0; i < 15; i++)
                {
                    BallState ball = simulator.Launch(new Vector3d(0, draw.Any(0.11, 0.11, 0.8), 0), draw.Between(0, 18) * draw.Heading(), draw.Vector(20));
                    Attempt(() => touches.Trap(in ball, new TrapRequest { Velocity = draw.Between(0, 3) * draw.Heading(), Duration = draw.Any(0, 0.2) }) is var touch ? touch.ToString() + touch.Spin + touch.Succeeds : "");
                    Attempt(() => touches.Dribble(in ball, new DribbleRequest { Direction = draw.Heading(), RunSpeed = draw.Between(2, 8), Lead = draw.Between(0.5, 3) }).ToString());
                    Attempt(() => touches.FirstTimeShot(in ball, new FirstTimeRequest { Target = (draw.Between(5, 20) * draw.Heading()) + new Vector3d(0, 1, 0), Speed = draw.Between(8, 28) }).ToString());
                }
            }
        }

        var foot = new Foot();
        for (int i = 0; i < 30; i++)
        {
            _ = foot.Strike(BallProperties.Modern, draw.Vector(5), draw.Vector(20), draw.Vector(18), draw.Vector(1).Normalized()).ToString();
            _ = foot.StrikeFor(BallProperties.Modern, draw.Vector(5), draw.Vector(20), draw.Vector(20), draw.Vector(20));
            ShieldResult shield = Touches.Shield(new ShieldRequest { Player = Runner(draw, 2), Opponents = [Runner(draw, 4), Runner(draw, 4)], Time = draw.Between(0.1, 1) });
            _ = shield.MarginAt(draw.Vector(3)) + shield.Margin + shield.Margins[0] + shield.SafeShare + shield.Position.X + (shield.IsShielded ? 1 : 0);
        }
    }

    private static Player Runner(Draw draw, double within) => new()
    {
        Position = draw.Between(0, within) * draw.Heading(),
        Velocity = draw.Between(0, 7) * draw.Heading(),
        Speed = draw.Between(5, 9),
        Acceleration = draw.Any(5, 40),
        Reaction = draw.Any(0, 0.3),
        Reach = draw.Between(0.3, 1),
        MaximumHeight = draw.Any(0.6, 2.3),
    };

    private static void Interceptions(Draw draw)
    {
        Scene scene = Pitch.Standard.On();
        var simulator = new Simulator(scene);
        var search = new Interception();
        var path = new Trajectory();
        for (int i = 0; i < 60; i++)
        {
            (Vector3d velocity, Vector3d spin) = draw.Kick();
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, spin);
            simulator.LookAhead(in ball, new LookAheadRequest { Duration = 6, StopAt = StopAt.Rest }, path);
            Player[] runners = [.. Enumerable.Range(0, 1 + draw.Below(12)).Select(_ => Runner(draw, 30))];
            search.Find(path, runners, draw.Chance(0.3) ? 0.2 : null, draw.Chance(0.3) ? 3 : null);
            _ = runners[0].ToString();
            foreach (PossessionInterval share in search.FindShares())
            {
                _ = share.ToString();
            }

            _ = search.Windows.Length;
            for (int at = 0; at < runners.Length; at++)
            {
                foreach (InterceptWindow window in search.WindowsOf(at))
                {
                    _ = window.ToString();
                }
            }

            _ = search.FindFirst(path, runners, out PathPoint first);
            _ = first.ToString();
            BallState shot = simulator.Launch(new Vector3d(draw.Between(-8, 8), 0.11, -40), new Vector3d(draw.Between(-6, 6), draw.Between(0, 6), -draw.Between(12, 30)), draw.Vector(40));
            simulator.LookAhead(in shot, new LookAheadRequest { Duration = 3 }, path);
            _ = search.FindSave(path, Runner(draw, 1) with { Position = new Vector3d(draw.Between(-2, 2), 0, -52) }, scene.Goals[0]).ToString();
            _ = search.FindSave(path, Runner(draw, 1) with { Position = new Vector3d(draw.Between(-2, 2), 0, -52) }, scene.Goals[^1]).ToString();
        }
    }

    // A target that no kick can have is refused.
    private static void Attempt(Func<string> search)
    {
        try
        {
            _ = search();
        }
        catch (ArgumentException)
        {
        }
        catch (InvalidOperationException)
        {
        }
    }
}
