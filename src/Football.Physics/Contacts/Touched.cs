namespace FootballPhysics.Contacts;

/// <summary>A stationary surface that a ball touches.</summary>
internal readonly unsafe struct Touched
{
    /// <summary>Maximum number of surfaces of a set.</summary>
    public const int Most = 3;

    /// <summary>Index of the collider.</summary>
    public readonly int Collider;

    /// <summary>True if its normal is constant as the ball moves.</summary>
    public readonly bool IsFixed;

    /// <summary>n, towards the ball.</summary>
    public readonly Vector3d Normal;

    /// <summary>μ_s, c₀, c₁, c_ω/I and b μ_s m/I of the surface.</summary>
    public readonly double Sliding;
    public readonly double Rolling;
    public readonly double RollingBySpeed;
    public readonly double Damping;
    public readonly double Drilling;

    private Touched(int index, Collider collider, in ShapePoint at, in BallState s, BallProperties ball)
    {
        ref readonly ContactMaterial material = ref collider.MaterialAt(s.Position);
        Collider = index;
        IsFixed = at.IsFlat && (collider.HasFaces || collider.IsPlane);
        Normal = at.Normal;
        Sliding = material.SlidingFriction;
        Rolling = material.RollingFriction;
        RollingBySpeed = material.RollingFrictionBySpeed;
        Damping = material.SpinDamping / ball.MomentOfInertia;
        Drilling = material.DrillingLength * material.SlidingFriction * ball.Mass / ball.MomentOfInertia;
    }

    /// <summary>Finds the touched surfaces, if all are stationary, their normals differ, and the ball reaches no other object in a
    /// step.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="reach">Upper bound of the ball's displacement, m.</param>
    /// <param name="set">Receives them, in scene order.</param>
    /// <returns>Their number; 0 if the ball may reach another object.</returns>
    public static int Find(World world, in BallState s, double dt, double reach, Touched* set)
    {
        // Query the engine for all colliders within reach only if the ball touches several surfaces.
        if (world.Engine is { } engine)
        {
            if (reach > ContactTolerances.Touching && Find(world, in s, dt, ContactTolerances.Touching, set) < 2)
            {
                return 0;
            }

            engine.LookAt(s.Position, s.Time, reach);
        }

        int count = 0;
        double radius = world.Ball.Radius;
        var near = new NearThings(world, new Bounds3d(s.Position, s.Position).Expanded(radius + reach), s.Time, dt, withPassages: true);
        while (near.Next(out int thing))
        {
            if (world.IsPassage(thing))
            {
                return 0;
            }

            // Reject the set if a moving surface, or a stationary one that the ball does not touch, comes near.
            Collider collider = world.Colliders[thing];
            ShapePoint at = collider.At(s.Position, s.Time);
            double gap = at.Distance - radius;
            bool isStill = collider.StandsStill;
            if (isStill && gap > reach)
            {
                continue;
            }

            if (!isStill || count == Most || !(Math.Abs(gap) <= ContactTolerances.OffSurface))
            {
                return 0;
            }

            int place = count++;
            for (int i = 0; i < place; i++)
            {
                if (Vector3d.Dot(in set[i].Normal, at.Normal) > 1.0 - ContactTolerances.SameNormal)
                {
                    return 0;
                }
            }

            for (; place > 0 && world.ComesFirst(thing, at.Normal, set[place - 1].Collider, in set[place - 1].Normal); place--)
            {
                set[place] = set[place - 1];
            }

            set[place] = new Touched(thing, collider, in at, in s, world.Ball);
        }

        return count;
    }

    /// <summary>True if a ball that moves straight to another position stays on the same flat face and material of a surface.</summary>
    public static bool KeepsSurface(World world, in Touched touched, in BallState s, in Vector3d to)
    {
        Collider collider = world.Colliders[touched.Collider];
        return !(collider.HasFaces && !(collider.FaceMargin(in to, s.Time) > 0)) && KeepsMaterial(collider, s.Position, in to);
    }

    private static bool KeepsMaterial(Collider collider, in Vector3d from, in Vector3d to) =>
        !collider.HasPatches || (collider.PatchAt(in from) == collider.PatchAt(in to) && collider.LeastWidth >= 2.0 * (to - from).Length);

    /// <summary>Moves a ball that still touches the same surfaces.</summary>
    public static void Move(ref BallState s, in Vector3d position, in Vector3d velocity, in Vector3d spin, in Vector3d turn, double end)
    {
        s.BaseOrientation = s.BaseOrientation.Turned(in turn);
        s.Position = position;
        s.Velocity = velocity;
        s.SpinAxis = spin;
        s.Time = end;
        s.ClearUntil = 0;
        s.ClearIn = BallState.TouchesSeveral;
    }
}
