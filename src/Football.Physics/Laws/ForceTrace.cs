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

    /// <summary>Weights of the error of order 5 of <see cref="Integration.HighOrder.Eighth"/> (Hairer, Nørsett and Wanner, DOP853: ER).</summary>
    private static readonly double[] s_fifth =
    [
        0.1312004499419488073250102996e-1, 0, 0, 0, 0, -0.1225156446376204440720569753e1, -0.4957589496572501915214079952, 0.1664377182454986536961530415e1,
        -0.3503288487499736816886487290, 0.3341791187130174790297318841, 0.8192320648511571246570742613e-1, -0.2235530786388629525884427845e-1,
    ];

    /// <summary>Weights of its error of order 3 (DOP853: B − BHH).</summary>
    private static readonly double[] s_third =
    [
        5.42937341165687622380535766363e-2 - 0.244094488188976377952755905512, 0, 0, 0, 0, 4.45031289275240888144113950566, 1.89151789931450038304281599044,
        -5.8012039960010585847814672114227, 3.1116436695781989440891606237e-1 - 0.733846688281611857341361741547, -1.52160949662516078556178806805e-1,
        2.01365400804030348374776537501e-1, 4.47106157277725905176885569043e-2 - 0.220588235294117647058823529412e-1,
    ];

    /// <summary>The share of the third order in the error: that of DOP853.</summary>
    private const double ShareOfThird = 0.1;

    /// <summary>The accelerations, then the torques as accelerations of the ball's surface, m/s².</summary>
    private fixed double _forces[Most * Axes];
    private fixed double _torques[Most * Axes];
    private double _radius;
    private double _length;

    /// <summary>The number of stages so far.</summary>
    public int Count;

    /// <summary>The velocity and the spin of the last stage, m/s and rad/s.</summary>
    public Vector3d LastVelocity;
    public Vector3d LastSpin;

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
    /// <remarks>
    /// With f at the four stages, f₂ − f₃ and f₁ − f₂ − f₃ + f₄ are of second order: z² |f|/4 for a spring or a damping of the rate z/h. Divided by |f|/4, they
    /// give z², and their product is the order of the method. A constant part of the force would hide the rest, so the change of the force counts as much as its
    /// size. Where the force has an edge, the second factor is 1.
    /// </remarks>
    public readonly double ErrorOfClassical() => Math.Max(
        ErrorOfClassical(ForceAt(0), ForceAt(1), ForceAt(2), ForceAt(3)), ErrorOfClassical(TorqueAt(0), TorqueAt(1), TorqueAt(2), TorqueAt(3)));

    /// <summary>Returns the error of a step of order 8, per time, in m/s².</summary>
    public readonly double ErrorOfEighth()
    {
        Vector3d fifth = Vector3d.Zero;
        Vector3d third = Vector3d.Zero;
        Vector3d fifthTorque = Vector3d.Zero;
        Vector3d thirdTorque = Vector3d.Zero;
        for (int i = 0; i < Most; i++)
        {
            Vector3d force = ForceAt(i);
            Vector3d torque = TorqueAt(i);
            fifth += s_fifth[i] * force;
            third += s_third[i] * force;
            fifthTorque += s_fifth[i] * torque;
            thirdTorque += s_third[i] * torque;
        }

        return Math.Max(Combined(fifth.Length, third.Length), Combined(fifthTorque.Length, thirdTorque.Length));
    }

    /// <summary>Returns h² times the squared rate at which the forces change the motion, from the first and the last stage.</summary>
    /// <param name="h">The length of the step, s.</param>
    /// <param name="moved">The displacement between these stages, m.</param>
    /// <param name="gained">The change of the velocity between them, m/s.</param>
    /// <param name="spun">The change of the spin between them, as a speed of the surface, m/s.</param>
    public readonly double Stiffness(double h, double moved, double gained, double spun)
    {
        int end = Math.Min(Count, Most) - 1;

        // A force follows the velocity at the rate |Δf|/|Δv|, or the position at the squared rate |Δf|/|Δp|. The lower one explains the change.
        double change = (ForceAt(end) - ForceAt(0)).Length;
        double byVelocity = change == 0 ? 0 : h * change / gained;
        double byPosition = change == 0 ? 0 : h * h * change / moved;
        double turning = (TorqueAt(end) - TorqueAt(0)).Length;
        double bySpin = turning == 0 ? 0 : h * turning / spun;
        return Math.Max(Math.Min(byVelocity * byVelocity, byPosition), bySpin * bySpin);
    }

    private static double ErrorOfClassical(in Vector3d first, in Vector3d second, in Vector3d third, in Vector3d fourth)
    {
        double largest = Math.Max(Math.Max(first.Length, second.Length), Math.Max(third.Length, fourth.Length));
        double range = Math.Max((second - first).Length, Math.Max((third - first).Length, (fourth - first).Length));
        double change = Math.Max((second - third).Length, (first - second - third + fourth).Length);
        return change == 0 ? 0 : change / 6.0 * Math.Min(1.0, 4.0 * change / Math.Sqrt(largest * range));
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
