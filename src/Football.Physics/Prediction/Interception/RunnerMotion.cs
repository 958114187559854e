namespace FootballPhysics.Prediction;

/// <summary>Where a runner can be at a time: within a circle that is carried along until he reacts, and grows from then on.</summary>
internal readonly struct RunnerMotion
{
    /// <summary>A ball this much beside his heights still counts, m: it is far below the error of a path, and lets a ball roll at his lowest height.</summary>
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

        // c = p₀ + v₀ τ
        _x = runner.Position.X + (runner.Reaction * _velocityX);
        _z = runner.Position.Z + (runner.Reaction * _velocityZ);
        Reach = runner.Reach;
        Carried = Math.Sqrt((_velocityX * _velocityX) + (_velocityZ * _velocityZ));
        Lowest = runner.MinimumHeight - HeightSlack;
        Highest = runner.MaximumHeight + HeightSlack;
    }

    /// <summary>When he reacts, s.</summary>
    public double Start { get; }

    /// <summary>ρ, m.</summary>
    public double Reach { get; }

    /// <summary>How fast he goes until he reacts, m/s.</summary>
    public double Carried { get; }

    /// <summary>Least height, m.</summary>
    public double Lowest { get; }

    /// <summary>Greatest height, m.</summary>
    public double Highest { get; }

    /// <summary>A bound of how fast the rim of his circle comes towards any point, m/s.</summary>
    public double Fastest => Math.Max(Carried, _speed);

    /// <summary>How fast his circle's middle goes at a time, m/s; at its jump the one after.</summary>
    public double CarriedAt(double time) => time < Start ? Carried : 0;

    /// <summary>The middle of his circle, m.</summary>
    public void MiddleAt(double time, out double x, out double z)
    {
        // He goes on until he reacts; from then on the circle grows about where he was then.
        double before = Math.Min(time - Start, 0);
        x = _x + (before * _velocityX);
        z = _z + (before * _velocityZ);
    }

    /// <summary>Velocity of the middle, m/s.</summary>
    public void MiddleVelocity(bool reacts, out double x, out double z)
    {
        x = reacts ? 0 : _velocityX;
        z = reacts ? 0 : _velocityZ;
    }

    /// <summary>Radius of his circle, D + ρ, m.</summary>
    public double RadiusAt(double time)
    {
        // D(s) = ½ a s² while s ≤ v/a, then v (s − v/2a)
        double s = time - Start;
        return Reach + (s <= 0 ? 0 : s <= _rampTime ? 0.5 * _acceleration * s * s : _speed * (s - (0.5 * _rampTime)));
    }

    /// <summary>How fast it grows, m/s.</summary>
    public double GrowthAt(double time) => Math.Min(Math.Max(0, time - Start) * _acceleration, _speed);

    /// <summary>A bound of how fast that grows from a time on, m/s².</summary>
    public double GrowthRateFrom(double time) => time - Start < _rampTime ? _acceleration : 0;

    /// <summary>The first time at which a distance from the middle is within his circle, s: the inverse of <see cref="RadiusAt"/>.</summary>
    public double ArrivalAt(double distance)
    {
        // s = √(2 d/a) up to ½ v²/a, then d/v + v/2a.
        double run = distance - Reach;
        return run <= 0 ? Start
            : run <= 0.5 * _speed * _rampTime ? Start + Math.Sqrt(2.0 * run / _acceleration)
            : Start + (run / _speed) + (0.5 * _rampTime);
    }
}
