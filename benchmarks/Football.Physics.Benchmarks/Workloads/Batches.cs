using MathNet.Numerics.LinearAlgebra;

namespace FootballPhysics.Benchmarks;

/// <summary>The timed loops. Each returns a value that depends on every step, so that the compiler cannot remove any.</summary>
internal static class Batches
{
    /// <summary>Simulates one shot after another; each step depends on the one before.</summary>
    public static double Chain(Simulator simulator, ReadOnlySpan<BallState> shots, int steps, double h, StepLog log)
    {
        double sum = 0;
        foreach (BallState shot in shots)
        {
            BallState s = shot;
            for (int i = 0; i < steps; i++)
            {
                simulator.Step(ref s, h, log);
            }

            sum += s.Position.X;
        }

        return sum;
    }

    /// <summary>Simulates the chain among bodies that are moved before every step.</summary>
    public static double ChainAmong(Simulator simulator, KinematicBodies bodies, ReadOnlySpan<BallState> shots, int steps, double h, StepLog log)
    {
        double sum = 0;
        foreach (BallState shot in shots)
        {
            BallState s = shot;
            for (int k = 0; k < bodies.Count; k++)
            {
                KinematicBody body = bodies[k];
                body.MoveTo(StadiumScenes.Place(k), body.Velocity, 0);
            }

            for (int i = 0; i < steps; i++)
            {
                for (int k = 0; k < bodies.Count; k++)
                {
                    KinematicBody body = bodies[k];
                    body.MoveTo(body.Position + ((s.Time - body.Time) * body.Velocity), body.Velocity, s.Time);
                }

                simulator.Step(ref s, h, log);
            }

            sum += s.Position.X;
        }

        return sum;
    }

    /// <summary>Simulates the chain and reads the orientation after every step, like a game that draws the ball.</summary>
    public static double ChainWithOrientation(Simulator simulator, ReadOnlySpan<BallState> shots, int steps, double h, StepLog log)
    {
        double sum = 0;
        foreach (BallState shot in shots)
        {
            BallState s = shot;
            for (int i = 0; i < steps; i++)
            {
                simulator.Step(ref s, h, log);
                sum += s.Orientation.W;
            }

            sum += s.Position.X;
        }

        return sum;
    }

    /// <summary>Steps all shots once, then again: neighbouring steps are independent.</summary>
    public static double Interleaved(Simulator simulator, ReadOnlySpan<BallState> shots, Span<BallState> scratch, int steps, double h, StepLog log)
    {
        shots.CopyTo(scratch);
        for (int i = 0; i < steps; i++)
        {
            for (int k = 0; k < scratch.Length; k++)
            {
                simulator.Step(ref scratch[k], h, log);
            }
        }

        return scratch[^1].Position.X;
    }

    /// <summary>Runs one step of every shot, including all its events.</summary>
    public static double OneStepEach(Simulator simulator, ReadOnlySpan<BallState> shots, double h, StepLog log)
    {
        double sum = 0;
        foreach (BallState shot in shots)
        {
            BallState s = shot;
            simulator.Step(ref s, h, log);
            sum += s.Position.X;
        }

        log.Clear();
        return sum;
    }

    /// <summary>Simulates a kick at 60 Hz until it rests.</summary>
    public static double ToRest(Simulator simulator, in BallState kick, StepLog log, out int steps)
    {
        BallState s = kick;
        steps = 0;
        while (s.Motion != MotionState.Rest)
        {
            log.Clear();
            simulator.Step(ref s, 1.0 / 60, log);
            steps++;
        }

        return s.Position.X;
    }

    /// <summary>Computes the positions of all shots after a time, including all events.</summary>
    public static double LookAhead(Simulator simulator, ReadOnlySpan<BallState> shots, double h, double duration, StepLog log)
    {
        double sum = 0;
        foreach (BallState shot in shots)
        {
            BallState s = shot;
            log.Clear();
            simulator.Run(ref s, h, duration, StopAt.Time, log);
            sum += s.Position.X;
        }

        return sum;
    }

    /// <summary>Simulates one shot after another by the plain yardstick.</summary>
    public static double Chain(PlainFlight flight, ReadOnlySpan<PlainState> shots, int steps, double h)
    {
        double sum = 0;
        foreach (PlainState shot in shots)
        {
            PlainState s = shot;
            for (int i = 0; i < steps; i++)
            {
                flight.Step(ref s, h);
            }

            sum += s.Position.X;
        }

        return sum;
    }

    /// <summary>Steps all shots once, then again, by the plain yardstick.</summary>
    public static double Interleaved(PlainFlight flight, ReadOnlySpan<PlainState> shots, Span<PlainState> scratch, int steps, double h)
    {
        shots.CopyTo(scratch);
        for (int i = 0; i < steps; i++)
        {
            for (int k = 0; k < scratch.Length; k++)
            {
                flight.Step(ref scratch[k], h);
            }
        }

        return scratch[^1].Position.X;
    }

    /// <summary>Simulates one shot after another by the thesis' method.</summary>
    public static double Chain(ThesisBall ball, ReadOnlySpan<Shot> shots, int steps, float h)
    {
        double sum = 0;
        foreach (Shot shot in shots)
        {
            ball.Kick(shot);
            for (int i = 0; i < steps; i++)
            {
                ball.FixedUpdate(h);
            }

            sum += ball.Position.X;
        }

        return sum;
    }

    /// <summary>Simulates one shot after another by MathNet.Numerics.</summary>
    public static double Chain(MathNetFlight flight, ReadOnlySpan<Vector<double>> shots, int steps, double h)
    {
        double sum = 0;
        foreach (Vector<double> shot in shots)
        {
            sum += flight.Fly(shot, h, steps)[0];
        }

        return sum;
    }

    /// <summary>Simulates one shot after another by the general rigid-body engine.</summary>
    public static double Chain(RigidBodyEngine engine, ReadOnlySpan<PlainState> shots, int steps, double h)
    {
        double sum = 0;
        foreach (PlainState shot in shots)
        {
            PlainState s = shot;
            for (int i = 0; i < steps; i++)
            {
                engine.Step(ref s, h);
            }

            sum += s.Position.X;
        }

        return sum;
    }
}
