namespace FootballPhysics.Labs.Groups;

/// <summary>The place of a group.</summary>
internal enum GroupPlace
{
    /// <summary>No ground, gravity or air: momentum is constant, and only contacts change the energy.</summary>
    EmptySpace,

    /// <summary>Level ground of any material, without air.</summary>
    Ground,

    /// <summary>A box of boards on the ground, without air.</summary>
    Box,

    /// <summary>A pitch with goals, in wind.</summary>
    Pitch,
}

/// <summary>What became of a group.</summary>
/// <param name="Place">The place.</param>
/// <param name="IsNumber">False if a number of a state was not finite, or the step threw.</param>
/// <param name="Contacts">The impacts between balls.</param>
/// <param name="Momentum">The largest change of the momentum in empty space, relative to the balls' own.</param>
/// <param name="Energy">The largest gain of energy in a step, relative to the largest energy; 0 on a pitch, whose wind adds energy.</param>
internal sealed record GroupOutcome(GroupPlace Place, bool IsNumber, int Contacts, double Momentum, double Energy)
{
    /// <summary>The rounding of sums of a few balls over some hundred steps.</summary>
    private const double Rounding = 1e-12;

    /// <summary>The energy that a step may gain by rounding, and by the correction of a ball's position on a surface.</summary>
    private const double Gain = 1e-9;

    public bool Holds => IsNumber && Momentum <= Rounding && Energy <= (Place == GroupPlace.EmptySpace ? Rounding : Gain);
}

/// <summary>A random group of balls: sizes, materials, places, motions and steps.</summary>
internal sealed class GroupDraw
{
    private const double Duration = 1.5;

    /// <summary>The distance of the boards from the centre of the box, m: the longest row of balls touches two of them.</summary>
    private const double Wall = 1.8;

    private static readonly BallProperties[] s_balls =
    [
        .. BallProperties.Presets.Values,
        new() { Mass = 0.005, Radius = 0.008, InertiaFactor = 0.4 },
        new() { Mass = 0.02, Radius = 0.012, InertiaFactor = 0.4 },
        new() { Mass = 0.16, Radius = 0.028, InertiaFactor = 0.4 },
    ];

    private static readonly SurfaceMaterial[] s_contacts =
    [
        .. SurfaceMaterial.Presets.Values.Where(material => material.NormalRestitution <= 1),
        SurfaceMaterial.Ball with { ImpactFriction = double.PositiveInfinity },
        SurfaceMaterial.Ball with { ImpactFriction = double.PositiveInfinity, TangentialRestitution = 0.6 },
        SurfaceMaterial.Ball with { ImpactFriction = 0 },
        SurfaceMaterial.Ball with { NormalRestitution = 0, ImpactFriction = double.PositiveInfinity, TorsionalPatchRadius = 0 },
        SurfaceMaterial.Ball with { NormalRestitution = 1, RestitutionSpeedScale = double.PositiveInfinity },
    ];

    private readonly GroupPlace _place;
    private readonly BallGroup _group;
    private readonly BallState[] _states;
    private readonly BallProperties[] _balls;
    private readonly double _gravity;
    private readonly double _step;

    private GroupDraw(SeededRandom random)
    {
        _place = random.Any(GroupPlace.EmptySpace, GroupPlace.EmptySpace, GroupPlace.Ground, GroupPlace.Box, GroupPlace.Pitch);
        _balls = new BallProperties[2 + random.Below(8)];
        BallProperties one = random.Any<BallProperties>(s_balls);
        bool equal = random.Chance(0.5);
        for (int i = 0; i < _balls.Length; i++)
        {
            _balls[i] = equal ? one : random.Any<BallProperties>(s_balls);
        }

        Scene scene = Scene(random);
        _gravity = scene.Gravity;
        var settings = new SolverSettings { Integrator = random.Any(Integrator.Rk4, Integrator.Rk4, Integrator.Rk2) };
        _group = new BallGroup(scene, _balls, settings, random.Any<SurfaceMaterial>(s_contacts));
        _step = 1 / random.Any(30.0, 60, 60, 100, 144);
        _states = new BallState[_balls.Length];
        Launch(random);
    }

    /// <summary>Draws and plays a group.</summary>
    /// <param name="seed">The seed of all groups.</param>
    /// <param name="index">The number of the group.</param>
    public static GroupOutcome Play(long seed, long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));

        // The first numbers of neighbouring seeds are not independent.
        random.Next();
        return new GroupDraw(random).Play();
    }

    private GroupOutcome Play()
    {
        var log = new StepLog();
        int contacts = 0;
        Vector3d start = Momentum(out double size);
        double momentum = 0;
        double energy = Energy();
        double most = energy;
        double gain = 0;
        for (double time = 0; time < Duration; time += _step)
        {
            log.Clear();
            _group.Step(_states, _step, log);
            for (int i = 0; i < log.Events.Count; i++)
            {
                contacts += log.Events[i].OtherBall >= 0 ? 1 : 0;
            }

            if (!Array.TrueForAll(_states, state => state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite))
            {
                return new GroupOutcome(_place, false, contacts, double.NaN, double.NaN);
            }

            Vector3d now = Momentum(out double its);
            size = Math.Max(size, its);
            momentum = _place == GroupPlace.EmptySpace && size > 0 ? Math.Max(momentum, (now - start).Length / size) : 0;
            double left = Energy();
            most = Math.Max(most, Math.Abs(left));
            gain = _place == GroupPlace.Pitch || most == 0 ? 0 : Math.Max(gain, (left - energy) / most);
            energy = left;
        }

        return new GroupOutcome(_place, true, contacts, momentum, gain);
    }

    private Scene Scene(SeededRandom random)
    {
        SurfaceMaterial material = random.Any<SurfaceMaterial>([.. SurfaceMaterial.Presets.Values.Where(item => item.NormalRestitution <= 1)]);
        Scene still = new() { Air = new Air { Density = 0 } };
        return _place switch
        {
            GroupPlace.EmptySpace => still with { Ground = Ground.None, Gravity = 0 },
            GroupPlace.Ground => still with { Ground = Ground.Of(material) },
            GroupPlace.Box => still with { Ground = Ground.Of(material), Obstacles = [Board(1, 0), Board(-1, 0), Board(0, 1), Board(0, -1)] },
            _ => Pitch.Standard.On(new Scene { Ground = Ground.Of(material), Air = new Air { Wind = random.Uniform(0, 8) * random.Heading() } }),
        };

        Obstacle Board(double x, double z) => new()
        {
            Shape = new PlaneShape(Wall * new Vector3d(x, 0, z), new Vector3d(-x, 0, -z)),
            Surface = SurfaceMaterial.Board,
        };
    }

    /// <summary>Launches the balls next to each other: in a row that touches, in a cloud, towards its centre, or at rest with spins.</summary>
    private void Launch(SeededRandom random)
    {
        bool tight = random.Chance(0.4);
        bool still = random.Chance(0.2);
        double gap = random.Any(0, 1e-9, 1e-6, 1e-3, 0.05);
        double speed = random.Any(0.02, 1, 6, 20);
        double spin = random.Any(0, 5, 60);
        Vector3d drift = _place == GroupPlace.EmptySpace && random.Chance(0.5) ? 10 * random.Direction() : Vector3d.Zero;
        double x = -Wall;
        for (int i = 0; i < _states.Length; i++)
        {
            double r = _balls[i].Radius;
            Vector3d place = Free(random, i, tight);
            if (tight)
            {
                x += r;
                place = new Vector3d(x, r + (random.Chance(0.2) ? gap : 0), random.Chance(0.3) ? gap : 0);
                x += r + gap;
            }

            Vector3d velocity = still ? Vector3d.Zero : tight && i > 0 ? random.Any(0, 0, 0.005, 0.5) * random.Direction() : (speed * random.Next() * random.Direction()) - (0.5 * speed * place);
            _states[i] = _group.SimulatorOf(i).Launch(place, drift + velocity, random.Chance(0.4) ? Vector3d.Zero : spin * random.Direction());
        }
    }

    /// <summary>Returns a place in the cloud that overlaps none of the balls before.</summary>
    private Vector3d Free(SeededRandom random, int count, bool tight)
    {
        double r = _balls[count].Radius;
        for (double wide = 0.3; ; wide *= 1.1)
        {
            var place = new Vector3d(random.Uniform(-wide, wide), r + (random.Chance(0.5) ? 0 : random.Uniform(0, 2 * wide)), random.Uniform(-wide, wide));
            bool isFree = true;
            for (int i = 0; i < count; i++)
            {
                isFree &= (place - _states[i].Position).Length > r + _balls[i].Radius;
            }

            if (isFree || tight)
            {
                return place;
            }
        }
    }

    private Vector3d Momentum(out double size)
    {
        Vector3d sum = Vector3d.Zero;
        size = 0;
        for (int i = 0; i < _states.Length; i++)
        {
            Vector3d momentum = _balls[i].Mass * _states[i].Velocity;
            sum += momentum;
            size += momentum.Length;
        }

        return sum;
    }

    private double Energy()
    {
        double sum = 0;
        for (int i = 0; i < _states.Length; i++)
        {
            sum += 0.5 * ((_balls[i].Mass * _states[i].Velocity.LengthSquared) + (_balls[i].MomentOfInertia * _states[i].Spin.LengthSquared));
            sum += _balls[i].Mass * _gravity * _states[i].Position.Y;
        }

        return sum;
    }
}
