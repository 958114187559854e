using FootballPhysics.Scenes;

namespace FootballPhysics.Prediction;

/// <summary>The positions that a player can reach by a given time: a circle that moves with him until he reacts, and then grows.</summary>
internal readonly struct RunnerMotion
{
    /// <summary>The tolerance of his height limits, in m: far below the error of a path, but it admits a ball that rolls at his minimum height.</summary>
    private const double HeightSlack = 1e-9;

    private readonly double _x;
    private readonly double _z;
    private readonly double _velocityX;
    private readonly double _velocityZ;
    private readonly double _acceleration;
    private readonly double _speed;
    private readonly double _rampTime;

    public RunnerMotion(in Player runner, double now)
    {
        _velocityX = runner.Velocity.X;
        _velocityZ = runner.Velocity.Z;
        _acceleration = runner.Acceleration;
        _speed = runner.Speed;
        _rampTime = runner.Speed / runner.Acceleration;
        Start = now + runner.Reaction;

        // c is the centre of his circle, p₀ and v₀ are his position and velocity now, and τ is his reaction.
        // c = p₀ + v₀ τ
        _x = runner.Position.X + (runner.Reaction * _velocityX);
        _z = runner.Position.Z + (runner.Reaction * _velocityZ);
        Reach = runner.Reach;
        Carried = Math.Sqrt((_velocityX * _velocityX) + (_velocityZ * _velocityZ));
        Lowest = runner.MinimumHeight - HeightSlack;
        Highest = runner.MaximumHeight + HeightSlack;
    }

    /// <summary>The time of his reaction, in s.</summary>
    public double Start { get; }

    /// <summary>The reach ρ, in m.</summary>
    public double Reach { get; }

    /// <summary>His speed before the reaction, in m/s.</summary>
    public double Carried { get; }

    /// <summary>The minimum height, in m.</summary>
    public double Lowest { get; }

    /// <summary>The maximum height, in m.</summary>
    public double Highest { get; }

    /// <summary>An upper bound of the speed at which the rim of his circle approaches any point, in m/s.</summary>
    public double Fastest => Math.Max(Carried, _speed);

    /// <summary>Returns the speed of the circle's centre at a time, in m/s; 0 from the reaction on.</summary>
    public double CarriedAt(double time) => time < Start ? Carried : 0;

    /// <summary>Returns the centre of his circle, in m.</summary>
    public void MiddleAt(double time, out double x, out double z)
    {
        // Until he reacts, he keeps his motion; then the circle grows about his position at that time.
        double before = Math.Min(time - Start, 0);
        x = _x + (before * _velocityX);
        z = _z + (before * _velocityZ);
    }

    /// <summary>Returns the velocity of the centre, in m/s.</summary>
    public void MiddleVelocity(bool reacts, out double x, out double z)
    {
        x = reacts ? 0 : _velocityX;
        z = reacts ? 0 : _velocityZ;
    }

    /// <summary>Returns the radius of his circle, D + ρ, in m.</summary>
    public double RadiusAt(double time)
    {
        // s is the time since his reaction, a his acceleration, and v his speed.
        // The distance D(s) = ½ a s² while s ≤ v/a, then v (s − v/2a).
        double s = time - Start;
        return Reach + (s <= 0 ? 0 : s <= _rampTime ? 0.5 * _acceleration * s * s : _speed * (s - (0.5 * _rampTime)));
    }

    /// <summary>Returns the rate of growth of the radius, in m/s.</summary>
    public double GrowthAt(double time) => Math.Min(Math.Max(0, time - Start) * _acceleration, _speed);

    /// <summary>Returns an upper bound of the acceleration of the radius from a time on, in m/s².</summary>
    public double GrowthRateFrom(double time) => time - Start < _rampTime ? _acceleration : 0;

    /// <summary>Returns the first time at which his circle reaches a distance from its centre, in s; the inverse of <see cref="RadiusAt"/>.</summary>
    public double ArrivalAt(double distance)
    {
        // d is the distance that he runs, a his acceleration, and v his speed.
        // The time s = √(2 d/a) up to d = ½ v²/a, then d/v + v/2a.
        double run = distance - Reach;
        return run <= 0 ? Start
            : run <= 0.5 * _speed * _rampTime ? Start + Math.Sqrt(2.0 * run / _acceleration)
            : Start + (run / _speed) + (0.5 * _rampTime);
    }

    /// <summary>Computes the part of a goal line that is within his circle; empty if there is none.</summary>
    /// <param name="mouth">The goal.</param>
    /// <param name="time">The time, in s.</param>
    /// <param name="from">The left end, in m to the right of the middle of the goal.</param>
    /// <param name="to">The right end, in m to the right of the middle of the goal.</param>
    public void Covers(in GoalMouth mouth, double time, out double from, out double to)
    {
        MiddleAt(time, out double x, out double z);
        var middle = new Vector3d(x, 0, z);
        double off = mouth.BeforeMouth(in middle);
        mouth.Place(in middle, out double aside, out _);
        double radius = RadiusAt(time);
        double half = radius > Math.Abs(off) ? Math.Sqrt((radius * radius) - (off * off)) : double.NegativeInfinity;
        from = aside - half;
        to = aside + half;
    }
}
