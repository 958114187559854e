using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Simulation;

/// <summary>Hashes everything that determines the ball's path in a scene: its values, and sampled values of code (air laws, winds,
/// shapes).</summary>
/// <remarks>
/// Equal scenes have the same hash on every machine. Scenes that differ in a value have different hashes.
/// </remarks>
internal static class SceneHash
{
    /// <summary>The default knuckle force when the hash was defined, N: without a seed, earlier recordings hash it.</summary>
    private const double FormerKnuckleForce = 1.5;

    private const int Places = 16;

    public static ulong Of(Scene scene, SolverSettings settings, World world, Simulator simulator)
    {
        var key = new SceneKey();
        AddSettings(ref key, settings);
        AddBall(ref key, scene);
        AddAir(ref key, scene, simulator);
        AddGround(ref key, scene.Ground);
        AddColliders(ref key, world);
        foreach (NetSheet net in world.Nets)
        {
            key.Add(net.Bounds);
            key.Add(net.Normal);
            key.Add(net.Give);
            key.Add(net.ReturnSpeed);
            key.Add(net.HalfLength);
            key.Add(net.HalfWidth);
            key.Add(net.InFrame(new Vector3d(1, 2, 3)));

            // Hash the net's response to a ball that moves further into its centre, where the tension is positive.
            MotionRates push = net.Push(new Motion(0.5 * (net.Bounds.Min + net.Bounds.Max), new Vector3d(1, 2, 3) - (5 * net.Normal), new Vector3d(3, 2, 1)), 1);
            key.Add(push.Acceleration);
            key.Add(push.SpinAcceleration);
        }

        foreach (GoalMouth goal in world.Goals)
        {
            key.Add(goal.Bounds);
            key.Add(goal.Out);
        }

        key.Add(world.Engine is null ? 0 : 1);

        // Zones do not affect paths, but two machines must report the same events.
        foreach (Zone zone in scene.Zones)
        {
            AddZone(ref key, zone);
        }

        return key.Value;
    }

    /// <summary>Hashes the material of a contact pair.</summary>
    public static ulong Of(SurfaceMaterial surface)
    {
        var key = new SceneKey();
        Add(ref key, SceneFields.Material, surface);
        return key.Value;
    }

    private static void AddSettings(ref SceneKey key, SolverSettings settings)
    {
        key.Add((double)(int)settings.Integrator);
        key.Add((double)(int)settings.CollisionTiming);
        key.Add(settings.CollisionTolerance);
        key.Add((double)(int)settings.RollingTransition);
        key.Add(settings.LocateJump ? 1 : 0);
    }

    private static void AddBall(ref SceneKey key, Scene scene)
    {
        // Numbers without an effect are not hashed, so that a recording stays valid: those of the outputs of impacts, a lift that does not reverse, and the
        // knuckle force without a seed.
        bool hasKnuckle = scene.Forces.KnuckleSeed is not null;
        foreach (NumberField<BallProperties> field in SceneFields.Ball)
        {
            double value = field.Get(scene.Ball);
            if (field.Name != "pressure" && (field.Name != "reverseLift" || value != 0))
            {
                key.Add(field.Name == "knuckleForce" && !hasKnuckle ? FormerKnuckleForce : value);
            }
        }

        if (hasKnuckle)
        {
            key.AddInteger(scene.Ball.SeamSeed);
        }

        key.Add(Weight.Of(scene));
        if (scene.Ball.Ignores != 0)
        {
            AddLayers(ref key, scene);
        }
    }

    /// <summary>Hashes the layers, which have no effect on a ball that ignores none.</summary>
    private static void AddLayers(ref SceneKey key, Scene scene)
    {
        key.Add((double)scene.Ball.Ignores);
        foreach (int layer in scene.Obstacles.Select(item => item.Layer).Concat((scene.Bodies ?? Enumerable.Empty<KinematicBody>()).Select(item => item.Layer)).Concat(scene.Zones.Select(item => item.Layer)))
        {
            key.Add((double)layer);
        }
    }

    private static void AddAir(ref SceneKey key, Scene scene, Simulator simulator)
    {
        Add(ref key, SceneFields.Air, scene.Air);
        key.Add(scene.Air.Wind);

        // A wind field is code and cannot be hashed, so hash sampled values.
        for (int i = 0; i < Places && scene.Air.WindField is not null; i++)
        {
            key.Add(scene.Air.WindField.At(0.7 * i, Place(i)));
        }

        // Hash the air laws by their factors at speeds and spins that are typical of a match.
        for (int i = 0; i < Places; i++)
        {
            simulator.AirFactors(2 + (2.5 * i), 6.0 * ((7 * i) % Places), out double drag, out double lift, out double decay);
            key.Add(drag);
            key.Add(lift);
            key.Add(decay);
        }

        // Hash −0.5 for "no seed", because every seed is an integer.
        if (scene.Forces.KnuckleSeed is { } seed)
        {
            key.AddInteger(seed);
        }
        else
        {
            key.Add(-0.5);
        }

        foreach (IForce force in scene.Forces.CustomForces)
        {
            // A custom force may have state, so do not call it; hash its type name.
            foreach (char letter in force.GetType().FullName ?? "")
            {
                key.Add(letter);
            }
        }
    }

    private static void AddGround(ref SceneKey key, Ground ground)
    {
        Add(ref key, SceneFields.Ground, ground);
        key.Add(ground.TangentialRestitutionZ ?? ground.Material.TangentialRestitution);
        key.Add((double)(int)ground.Aerodynamics);
        key.Add(ground.IsNone ? 1 : 0);
    }

    private static void AddColliders(ref SceneKey key, World world)
    {
        // Engine colliders come and go, so they are not part of the scene.
        foreach (Collider collider in world.Colliders.Take(world.FirstPassage).Where(collider => world.Engine is null || !world.Engine.Colliders.Contains(collider)))
        {
            key.Add(collider.Mass);
            key.Add(collider.Given.Velocity);
            key.Add(collider.Given.Spin);
            key.Add(collider.Given.Pivot);
            key.Add(in collider.Bounds);
            for (int i = 0; i < Places; i++)
            {
                // Sample the shape in its own frame, near it and far from it.
                Vector3d place = (i % 2 == 0 ? 0.02 : 1.0) * Place(i);
                ShapePoint at = collider.At(in place);
                key.Add(at.Distance);
                key.Add(at.Normal);
                key.Add(collider.PatchAt(in place));
            }

            foreach (SurfaceMaterial surface in collider.Surfaces)
            {
                Add(ref key, SceneFields.Material, surface);
            }
        }
    }

    private static void AddZone(ref SceneKey key, Zone zone)
    {
        key.Add((double)(int)zone.Of);
        key.Add(zone.Shape.Bounds);
        for (int i = 0; i < Places; i++)
        {
            ShapePoint at = zone.Shape.At((i % 2 == 0 ? 0.02 : 1.0) * Place(i));
            key.Add(at.Distance);
            key.Add(at.Normal);
        }
    }

    /// <summary>Hashes the values of a part of the scene.</summary>
    private static void Add<T>(ref SceneKey key, NumberField<T>[] fields, T part)
    {
        foreach (NumberField<T> field in fields)
        {
            key.Add(field.Get(part));
        }
    }

    /// <summary>Returns a sample position on or above the pitch, m.</summary>
    private static Vector3d Place(int i) => new(-52 + (7 * i), 0.11 + (0.9 * ((5 * i) % Places)), -33 + (4.3 * ((3 * i) % Places)));
}

/// <summary>A hash of numbers; every input bit affects every bit of the hash.</summary>
internal struct SceneKey
{
    private ulong _hash;

    /// <summary>The hash so far.</summary>
    public readonly ulong Value => _hash;

    /// <summary>Adds a number.</summary>
    public void Add(double value)
    {
        // Use the finaliser of MurmurHash3 on each number, so that differences in only the first or last bits do not cancel.
        ulong h = _hash ^ (ulong)BitConverter.DoubleToInt64Bits(value) ^ 0x9E3779B97F4A7C15UL;
        h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDUL;
        h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53UL;
        _hash = (h ^ (h >> 33)) + 0x9FB21C651E98DF25UL;
    }

    /// <summary>Adds an integer; a double holds only 53 of its bits.</summary>
    public void AddInteger(long value)
    {
        Add((double)(int)(value >> 32));
        Add((double)(uint)value);
    }

    /// <summary>Adds a vector.</summary>
    public void Add(in Vector3d value)
    {
        Add(value.X);
        Add(value.Y);
        Add(value.Z);
    }

    /// <summary>Adds a box.</summary>
    public void Add(in Bounds3d value)
    {
        Add(value.Min);
        Add(value.Max);
    }
}
