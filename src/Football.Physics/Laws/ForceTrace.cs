namespace FootballPhysics.Laws;

/// <summary>The custom forces at the stages of one step, per mass: they tell how accurately the step follows them.</summary>
/// <remarks>Only custom forces count, so that no other part of the motion shortens a piece. It lives on the stack of the phase that takes the piece.</remarks>
internal unsafe struct ForceTrace
{
    /// <summary>The maximum number of stages; later ones are dropped.</summary>
    private const int Most = 12;

    private const int Axes = 3;

    /// <summary>The largest change of the velocity by the force of any stage, m/s: a larger one is beyond all motions that a step of this length can follow.</summary>
    private const double MostGained = Limits.Speed;

    /// <summary>The share of the third order in the error: that of DOP853.</summary>
    private const double ShareOfThird = 0.1;

    /// <summary>The accelerations, then the torques as accelerations of the ball's surface, m/s².</summary>
    private fixed double _forces[Most * Axes];
    private fixed double _torques[Most * Axes];
    private double _radius;
    private double _length;

    /// <summary>The number of stages so far.</summary>
    public int Count;

    /// <summary>The motion at the last stage.</summary>
    public Motion Last;

    /// <summary>True if a stage has shown that the step is far too long. The forces are not evaluated any more, because their input is not a motion of the ball.</summary>
    public bool IsWild;

    /// <summary>Begins without stages; the first one is the start of the step.</summary>
    /// <param name="radius">r, m: it converts torques.</param>
    public void Begin(double radius)
    {
        _radius = radius;
        _length = 0;
        Count = 0;
        IsWild = false;
    }

    /// <summary>Forgets all stages except the start, before a step is taken.</summary>
    /// <param name="h">The length of the step, s.</param>
    public void Restart(double h)
    {
        Count = 1;
        _length = h;
        IsWild = false;
    }

    /// <summary>Returns the longest step in which the force at the start does not change the velocity beyond all bounds, s.</summary>
    public readonly double LongestStep => MostGained / Math.Max(ForceAt(0).Length, TorqueAt(0).Length);

    /// <summary>Adds a stage.</summary>
    public void Add(in Vector3d acceleration, in Vector3d spinAcceleration)
    {
        if (Count < Most)
        {
            Set(Count, in acceleration, in spinAcceleration);
            IsWild |= Count > 0 && !(_length * Math.Max(ForceAt(Count).Length, TorqueAt(Count).Length) <= MostGained);
        }

        Count++;
    }

    /// <summary>Returns the force per mass at a stage, m/s².</summary>
    public readonly Vector3d ForceAt(int stage) => new(_forces[stage * Axes], _forces[(stage * Axes) + 1], _forces[(stage * Axes) + 2]);

    /// <summary>Returns the torque at a stage, as an acceleration of the surface, m/s².</summary>
    public readonly Vector3d TorqueAt(int stage) => new(_torques[stage * Axes], _torques[(stage * Axes) + 1], _torques[(stage * Axes) + 2]);

    /// <summary>Returns a bound on the error of a step by RK4, per time, in m/s².</summary>
    /// <param name="h">The length of the step, s.</param>
    /// <param name="from">The motion at the first stage.</param>
    /// <remarks>
    /// With f at the four stages, f₂ − f₃ and f₁ − f₂ − f₃ + f₄ are of second order: z² |f|/4 for a spring or a damping of the rate z/h. Divided by |f|/4, they
    /// give z², and their product is the order of the method. A constant part of the force would hide the rest, so the change of the force counts as much as its
    /// size. If the force has an edge, the second factor is 1. Where an edge makes up for z²/4, both differences vanish: the last factor, z⁴/32, is the error then.
    /// </remarks>
    public readonly double ErrorOfClassical(double h, in Motion from)
    {
        double stiffness = Stiffness(h, in from, isLower: true);
        double ofEdge = stiffness * stiffness / 32.0;
        return Math.Max(
            ErrorOfClassical(ForceAt(0), ForceAt(1), ForceAt(2), ForceAt(3), ofEdge), ErrorOfClassical(TorqueAt(0), TorqueAt(1), TorqueAt(2), TorqueAt(3), ofEdge));
    }

    /// <summary>Returns the error of a step, per time, in m/s².</summary>
    /// <param name="ofFifth">The weights of the stages in an estimate of order 5.</param>
    /// <param name="ofThird">Those in an estimate of order 3.</param>
    public readonly double Error(double[] ofFifth, double[] ofThird)
    {
        Vector3d fifth = Vector3d.Zero;
        Vector3d third = Vector3d.Zero;
        Vector3d fifthTorque = Vector3d.Zero;
        Vector3d thirdTorque = Vector3d.Zero;
        for (int i = 0; i < Most; i++)
        {
            Vector3d force = ForceAt(i);
            Vector3d torque = TorqueAt(i);
            fifth += ofFifth[i] * force;
            third += ofThird[i] * force;
            fifthTorque += ofFifth[i] * torque;
            thirdTorque += ofThird[i] * torque;
        }

        return Math.Max(Combined(fifth.Length, third.Length), Combined(fifthTorque.Length, thirdTorque.Length));
    }

    /// <summary>Returns h² times the squared rate at which the forces change the motion.</summary>
    /// <param name="h">The length of the step, s.</param>
    /// <param name="from">The motion at the first stage.</param>
    /// <param name="isLower">True for the lower of two estimates; false for the one that springs have.</param>
    public readonly double Stiffness(double h, in Motion from, bool isLower)
    {
        // A force follows the velocity at the rate |Δf|/|Δv|, or the position at the squared rate |Δf|/|Δp|. For a spring near its turning point, the first one is too low;
        // for the damping of a slow ball that falls, the second one is too high.
        double change = 0;
        double turning = 0;
        for (int i = 1; i < Math.Min(Count, Most); i++)
        {
            change = Math.Max(change, (ForceAt(i) - ForceAt(0)).Length);
            turning = Math.Max(turning, (TorqueAt(i) - TorqueAt(0)).Length);
        }

        double byVelocity = change == 0 ? 0 : h * change / (Last.Velocity - from.Velocity).Length;
        double byPosition = change == 0 ? 0 : h * h * change / (Last.Position - from.Position).Length;
        double bySpin = turning == 0 ? 0 : h * turning / (_radius * (Last.Spin - from.Spin).Length);
        return Math.Max(isLower ? Math.Min(byVelocity * byVelocity, byPosition) : byPosition, bySpin * bySpin);
    }

    private static double ErrorOfClassical(in Vector3d first, in Vector3d second, in Vector3d third, in Vector3d fourth, double ofEdge)
    {
        double largest = Math.Max(Math.Max(first.Length, second.Length), Math.Max(third.Length, fourth.Length));
        double range = Math.Max((second - first).Length, Math.Max((third - first).Length, (fourth - first).Length));
        double change = Math.Max((second - third).Length, (first - second - third + fourth).Length);
        return range == 0 ? 0 : Math.Max(change / 6.0 * Math.Min(1.0, 4.0 * change / Math.Sqrt(largest * range)), range * ofEdge);
    }

    private static double Combined(double fifth, double third)
    {
        double other = ShareOfThird * third;
        return fifth == 0 ? 0 : fifth * fifth / Math.Sqrt((fifth * fifth) + (other * other));
    }

    private void Set(int stage, in Vector3d acceleration, in Vector3d spinAcceleration)
    {
        _forces[stage * Axes] = acceleration.X;
        _forces[(stage * Axes) + 1] = acceleration.Y;
        _forces[(stage * Axes) + 2] = acceleration.Z;
        _torques[stage * Axes] = _radius * spinAcceleration.X;
        _torques[(stage * Axes) + 1] = _radius * spinAcceleration.Y;
        _torques[(stage * Axes) + 2] = _radius * spinAcceleration.Z;
    }
}
