namespace Football.Physics;

/// <summary>
/// Balls that press each other, as one system, with the contacts and their modes locked (contacts.md, Balls on balls). With n and ṅ of the line of centres two balls
/// keep touching, n·(v̇₁ − v̇₂) = −ṅ·(v₁ − v₂); where they stick their slip v₁ − v₂ + n × (r₁ ω₁ + r₂ ω₂) stays zero; where they slip F = −μ N ŝ. Contacts with
/// what stands still are those of <see cref="ContactSystem"/>. One linear system gives all loads and friction forces; the method advances all balls together.
/// </summary>
internal sealed class ClusterSystem
{
    /// <summary>Balls that are solved together at most, and unknown forces of them.</summary>
    public const int MostBalls = 8;
    public const int MostRows = 64;

    /// <summary>Contacts of them at most.</summary>
    public const int MostContacts = 32;

    /// <summary>Forces that are not the only ones must meet their conditions to this, as a share of the largest, or there are none.</summary>
    private const double Met = 1e-7;

    private readonly ClusterRow[] _rows;
    private readonly double[] _g;
    private readonly double[] _x;
    private readonly double[] _asked;

    /// <param name="room">Where the equations are put together: room that all clusters of a group share.</param>
    public ClusterSystem(ClusterRoom room)
    {
        _rows = room.Rows;
        _g = room.G;
        _x = room.X;
        _asked = room.Asked;
    }

    /// <summary>The balls.</summary>
    public ClusterBall[] Balls { get; } = new ClusterBall[MostBalls];

    /// <summary>How many there are.</summary>
    public int Count { get; set; }

    /// <summary>Their contacts.</summary>
    public ClusterContact[] Contacts { get; } = new ClusterContact[MostContacts];

    /// <summary>How many there are.</summary>
    public int ContactCount { get; set; }

    /// <summary>Length of the step that the forces are asked for, s.</summary>
    public double Length { get; set; }

    /// <summary>Right-hand sides evaluated for each ball.</summary>
    public int Evaluations { get; set; }

    /// <summary>Advances all balls from the start by one step of the method, with the rates at the start known, and looks at the contacts at its end.</summary>
    /// <param name="method">The method.</param>
    /// <param name="time">When the step starts, s.</param>
    /// <param name="h">Its length, s.</param>
    /// <returns>False where the forces of a stage do not exist.</returns>
    public bool Advance(IIntegrator method, double time, double h)
    {
        double half = 0.5 * h;
        bool holds = true;
        switch (method.Order)
        {
            case 4:
                // The rates at the start, twice in the middle and at the end, as in ClassicalRungeKutta.
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Motion from = From(in ball);
                    ball.Second = from.After(half, in from.Velocity, in ball.First);
                    ball.At = ball.Second;
                }

                holds &= Rates(time + half);
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    ball.SecondRates = ball.Rates;
                    ball.Third = From(in ball).After(half, in ball.Second.Velocity, in ball.SecondRates);
                    ball.At = ball.Third;
                }

                holds &= Rates(time + half);
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    ball.ThirdRates = ball.Rates;
                    ball.At = From(in ball).After(h, in ball.Third.Velocity, in ball.ThirdRates);
                }

                holds &= Rates(time + h);
                for (int i = 0; i < Count; i++)
                {
                    EndClassical(ref Balls[i], h);
                }

                break;
            case 2:
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Motion from = From(in ball);
                    ball.At = from.After(half, in from.Velocity, in ball.First);
                }

                holds &= Rates(time + half);
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Vector3d rotation = h * ball.At.Spin;
                    End(ref ball, From(in ball).After(h, ball.At.Velocity, in ball.Rates), in rotation);
                }

                break;
            default:
                // Of order one: the place with the velocity at the start, or with the new one.
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Motion from = From(in ball);
                    Vector3d after = from.Velocity + (method.ShareInPath * h * ball.First.Acceleration);
                    Motion end = from.After(h, in after, in ball.First);
                    Vector3d rotation = h * (method.ShareInPath > 0 ? end.Spin : from.Spin);
                    End(ref ball, in end, in rotation);
                }

                break;
        }

        return holds;
    }

    /// <summary>Loads, friction and slips where the balls are at the end.</summary>
    public bool LookAtEnd(double time)
    {
        for (int i = 0; i < Count; i++)
        {
            ref ClusterBall ball = ref Balls[i];
            ball.At = MotionOf(in ball.End);
        }

        bool holds = Rates(time);
        for (int i = 0; i < Count; i++)
        {
            Balls[i].Last = Balls[i].Rates;
        }

        return holds;
    }

    /// <summary>What acts on the balls where they are, but for their contacts; and how the contacts are.</summary>
    public void Look(double time)
    {
        for (int i = 0; i < Count; i++)
        {
            ref ClusterBall ball = ref Balls[i];
            BallState s = ball.Start;
            s.Time = time;
            s.Position = ball.At.Position;
            s.Velocity = ball.At.Velocity;
            s.SpinAxis = ball.At.Spin;
            s.AirDistance = ball.At.AirDistance;
            ball.Free = ball.Pile.Free(in s, Length, atRest: false);
        }

        Evaluations++;
        for (int i = 0; i < ContactCount; i++)
        {
            Look(ref Contacts[i], time);
        }
    }

    /// <summary>The motion of a ball.</summary>
    public static Motion MotionOf(in BallState s) => new(s.Position, s.Velocity, s.Spin, s.AirDistance);

    private static Motion From(in ClusterBall ball) => MotionOf(in ball.Start);

    private static void EndClassical(ref ClusterBall ball, double h)
    {
        double sixth = h / 6.0;
        Motion from = From(in ball);
        ref readonly MotionRates k1 = ref ball.First;
        ref readonly MotionRates k2 = ref ball.SecondRates;
        ref readonly MotionRates k3 = ref ball.ThirdRates;
        ref readonly MotionRates k4 = ref ball.Rates;

        // y' = y + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄)
        var end = new Motion(
            from.Position + (sixth * (from.Velocity + (2.0 * (ball.Second.Velocity + ball.Third.Velocity)) + ball.At.Velocity)),
            from.Velocity + (sixth * (k1.Acceleration + (2.0 * (k2.Acceleration + k3.Acceleration)) + k4.Acceleration)),
            from.Spin + (sixth * (k1.SpinAcceleration + (2.0 * (k2.SpinAcceleration + k3.SpinAcceleration)) + k4.SpinAcceleration)),
            from.AirDistance + (sixth * (k1.AirSpeed + (2.0 * (k2.AirSpeed + k3.AirSpeed)) + k4.AirSpeed)));
        Vector3d rotation = RotationVector.Of(in from.Spin, 0.5 * (ball.Second.Spin + ball.Third.Spin), in end.Spin, h);
        End(ref ball, in end, in rotation);
    }

    private static void End(ref ClusterBall ball, in Motion end, in Vector3d rotation)
    {
        ball.End = ball.Start;
        ball.End.BaseOrientation = ball.Start.BaseOrientation.Turned(in rotation);
        ball.End.Position = end.Position;
        ball.End.Velocity = end.Velocity;
        ball.End.SpinAxis = end.Spin;
        ball.End.AirDistance = end.AirDistance;
    }

    private void Look(ref ClusterContact contact, double time)
    {
        ref readonly ClusterBall ball = ref Balls[contact.First];
        if (contact.Second < 0)
        {
            contact.On.Look(ball.World, time, in ball.At);
            contact.Gap = contact.On.Bears ? 0 : ball.World.Colliders[contact.On.Collider].At(ball.At.Position, time).Distance - ball.Radius;
            return;
        }

        // ṅ = (v₁ − v₂)_t/|p₁ − p₂|
        ref readonly ClusterBall other = ref Balls[contact.Second];
        Vector3d apart = ball.At.Position - other.At.Position;
        double distance = apart.Length;
        ref SetContact on = ref contact.On;
        on.Turn(apart / distance);
        Vector3d relative = ball.At.Velocity - other.At.Velocity;
        Vector3d along = SurfaceSystem.Tangential(in relative, in on.Normal);
        on.Turning = along / distance;
        on.Centripetal = Vector3d.Dot(in on.Turning, in relative);
        on.Slip = along + Vector3d.Cross(in on.Normal, (ball.Radius * ball.At.Spin) + (other.Radius * other.At.Spin));
        contact.Gap = distance - ball.Radius - other.Radius;
    }

    private bool Rates(double time)
    {
        Look(time);
        return Solve();
    }

    /// <summary>Finds the forces of the contacts, and with them the rates.</summary>
    /// <returns>False where none meet all conditions.</returns>
    public unsafe bool Solve()
    {
        for (int i = 0; i < Count; i++)
        {
            SetFree(ref Balls[i]);
        }

        int size = 0;
        for (int i = 0; i < ContactCount; i++)
        {
            if (size + Contacts[i].Width > MostRows)
            {
                return false;
            }

            size = AddRows(i, size);
        }

        double largest = 0;
        for (int i = 0; i < size; i++)
        {
            HoldSpins(ref _rows[i]);
        }

        for (int i = 0; i < size; i++)
        {
            ref readonly ClusterRow row = ref _rows[i];
            _asked[i] = row.Asked - Along(in row);
            _x[i] = _asked[i];
            largest = Math.Max(largest, Math.Abs(_asked[i]));
            for (int j = 0; j < size; j++)
            {
                _g[(i * size) + j] = Response(in row, in _rows[j]);
            }
        }

        fixed (double* g = _g)
        fixed (double* x = _x)
        {
            if (size > 0 && !ContactRows.Solve(g, x, size) && !Meets(size, largest))
            {
                return false;
            }
        }

        Give(size);
        return true;
    }

    /// <summary>The rates without contacts: with the bearer's damping, and where drilling friction holds the spin about its normal.</summary>
    private void SetFree(ref ClusterBall ball)
    {
        Vector3d spin = ball.Free.SpinAcceleration;
        ball.HeldSpin = 0;
        if (ball.Bearer >= 0)
        {
            // ω̇_n = −(c_ω/I) (ω − Ω)·n; and d(ω·n)/dt = ω̇·n + ω·ṅ stays zero where it is held.
            ref readonly SetContact on = ref Contacts[ball.Bearer].On;
            spin -= on.Damping * (Vector3d.Dot(in ball.At.Spin, in on.Normal) - on.CarrierSpin) * on.Normal;
            ball.HeldSpin = ball.HoldsSpin ? -Vector3d.Dot(in ball.At.Spin, in on.Turning) - Vector3d.Dot(in spin, in on.Normal) : 0;
            spin += ball.HeldSpin * on.Normal;
        }

        ball.Rates = new MotionRates(ball.Free.Acceleration, in spin, ball.Free.AirSpeed);
    }

    private int AddRows(int index, int size)
    {
        ref readonly ClusterContact contact = ref Contacts[index];
        ref readonly SetContact on = ref contact.On;
        if (!on.Bears)
        {
            return size;
        }

        ref ClusterRow load = ref Begin(size++, in contact);
        Vector3d n = on.Normal;
        load.AlongV = n;
        load.OtherAlongV = -n;
        load.Asked = -on.Centripetal;
        Push(ref load, in n, on.Sticks ? default : -on.Sliding * DirectionOf(in on), in n);
        ref readonly ClusterBall ball = ref Balls[contact.First];
        if (contact.Second >= 0)
        {
            load.PushW -= contact.TwistSign * contact.Lever * ball.PerInertia * n;
            load.OtherPushW += contact.TwistSign * contact.Lever * Balls[contact.Second].PerInertia * n;
        }
        else if (ball.Bearer == index)
        {
            AddResistance(in ball, in on, ref load);
        }

        if (on.Sticks)
        {
            // t·(v̇₁ − v̇₂ + n × (r₁ ω̇₁ + r₂ ω̇₂)) = t·(A − ṅ × (r₁ ω₁ + r₂ ω₂))
            Vector3d turning = ball.Radius * ball.At.Spin;
            turning += contact.Second < 0 ? Vector3d.Zero : Balls[contact.Second].Radius * Balls[contact.Second].At.Spin;
            Vector3d asked = on.SurfaceRate - Vector3d.Cross(in on.Turning, in turning);
            AddStick(ref Begin(size++, in contact), in n, in on.First, in asked);
            AddStick(ref Begin(size++, in contact), in n, in on.Second, in asked);
        }

        if (contact.HoldsTwist)
        {
            // n·(ω̇₁ − ω̇₂) = −ṅ·(ω₁ − ω₂); the unknown is the torque by r₁, a force like the others.
            ref readonly ClusterBall other = ref Balls[contact.Second];
            ref ClusterRow twist = ref Begin(size++, in contact);
            twist.AlongW = ball.Radius * n;
            twist.OtherAlongW = -ball.Radius * n;
            twist.Asked = -ball.Radius * Vector3d.Dot(in on.Turning, ball.At.Spin - other.At.Spin);
            twist.PushW = ball.Radius * ball.PerInertia * n;
            twist.OtherPushW = -ball.Radius * other.PerInertia * n;
        }

        return size;
    }

    private ref ClusterRow Begin(int row, in ClusterContact contact)
    {
        _rows[row] = new ClusterRow { First = contact.First, Second = contact.Second };
        return ref _rows[row];
    }

    private void AddStick(ref ClusterRow row, in Vector3d n, in Vector3d along, in Vector3d asked)
    {
        Vector3d turned = Vector3d.Cross(in along, in n);
        row.AlongV = along;
        row.AlongW = Balls[row.First].Radius * turned;
        row.Asked = Vector3d.Dot(in asked, in along);
        if (row.Second >= 0)
        {
            row.OtherAlongV = -along;
            row.OtherAlongW = Balls[row.Second].Radius * turned;
        }

        Push(ref row, default, in along, in n);
    }

    /// <summary>A force on the first ball, and the opposite one on the second: along the normal, and along the surface, which turns both.</summary>
    private void Push(ref ClusterRow row, in Vector3d load, in Vector3d rub, in Vector3d n)
    {
        ref readonly ClusterBall ball = ref Balls[row.First];
        Vector3d force = load + rub;
        Vector3d turned = Vector3d.Cross(in n, in rub);
        row.PushV = ball.PerMass * force;
        row.PushW = -(ball.Radius * ball.PerInertia) * turned;
        if (row.Second >= 0)
        {
            ref readonly ClusterBall other = ref Balls[row.Second];
            row.OtherPushV = -other.PerMass * force;
            row.OtherPushW = -(other.Radius * other.PerInertia) * turned;
        }
    }

    /// <summary>Rolling resistance takes (c₀ + c₁|v|) N/m from the motion, spin and all; drilling friction b μ_s N/I from the spin about the normal.</summary>
    private static void AddResistance(in ClusterBall ball, in SetContact on, ref ClusterRow load)
    {
        load.PushW -= ball.SpinSign * on.Drilling * ball.PerMass * on.Normal;
        if (!on.Sticks)
        {
            return;
        }

        Vector3d rolling = SurfaceSystem.Tangential(in on.RollingVelocity, in on.Normal);
        double speed = rolling.Length;
        Vector3d direction = speed > 0 && Vector3d.Dot(in rolling, in ball.Along) > 0 ? rolling / speed : ball.Along;
        double share = (on.Rolling + (on.RollingBySpeed * speed)) * ball.PerMass;
        load.PushV -= share * direction;
        load.PushW -= share / ball.Radius * Vector3d.Cross(in on.Normal, in direction);
    }

    /// <summary>The direction of a slip, or that at the start where a stage has passed zero.</summary>
    private static Vector3d DirectionOf(in SetContact on)
    {
        double size = on.Slip.Length;
        return size > 0 && Vector3d.Dot(in on.Slip, in on.Direction) > 0 ? on.Slip / size : on.Direction;
    }

    /// <summary>Where drilling friction holds the spin of a ball, it takes what a force adds to that.</summary>
    private void HoldSpins(ref ClusterRow row)
    {
        row.Held = Hold(in Balls[row.First], ref row.PushW);
        row.OtherHeld = row.Second < 0 ? 0 : Hold(in Balls[row.Second], ref row.OtherPushW);
    }

    private double Hold(in ClusterBall ball, ref Vector3d turning)
    {
        if (!ball.HoldsSpin)
        {
            return 0;
        }

        Vector3d n = Contacts[ball.Bearer].On.Normal;
        double held = -Vector3d.Dot(in turning, in n);
        turning += held * n;
        return held;
    }

    /// <summary>What the balls do by themselves of what a condition asks for.</summary>
    private double Along(in ClusterRow row)
    {
        ref readonly MotionRates rates = ref Balls[row.First].Rates;
        double sum = Vector3d.Dot(in row.AlongV, in rates.Acceleration) + Vector3d.Dot(in row.AlongW, in rates.SpinAcceleration);
        if (row.Second >= 0)
        {
            ref readonly MotionRates other = ref Balls[row.Second].Rates;
            sum += Vector3d.Dot(in row.OtherAlongV, in other.Acceleration) + Vector3d.Dot(in row.OtherAlongW, in other.SpinAcceleration);
        }

        return sum;
    }

    /// <summary>What a unit of a force does of what a condition asks for.</summary>
    private static double Response(in ClusterRow row, in ClusterRow force)
    {
        double sum = 0;
        if (row.First == force.First)
        {
            sum += Vector3d.Dot(in row.AlongV, in force.PushV) + Vector3d.Dot(in row.AlongW, in force.PushW);
        }
        else if (row.First == force.Second)
        {
            sum += Vector3d.Dot(in row.AlongV, in force.OtherPushV) + Vector3d.Dot(in row.AlongW, in force.OtherPushW);
        }

        if (row.Second < 0)
        {
            return sum;
        }

        if (row.Second == force.First)
        {
            sum += Vector3d.Dot(in row.OtherAlongV, in force.PushV) + Vector3d.Dot(in row.OtherAlongW, in force.PushW);
        }
        else if (row.Second == force.Second)
        {
            sum += Vector3d.Dot(in row.OtherAlongV, in force.OtherPushV) + Vector3d.Dot(in row.OtherAlongW, in force.OtherPushW);
        }

        return sum;
    }

    /// <summary>True when forces that are not the only ones meet all conditions.</summary>
    private bool Meets(int size, double largest)
    {
        for (int i = 0; i < size; i++)
        {
            double left = _asked[i];
            for (int j = 0; j < size; j++)
            {
                left -= _g[(i * size) + j] * _x[j];
            }

            if (!(Math.Abs(left) <= Met * largest))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Gives the balls what the forces do, and says what each contact bears.</summary>
    private void Give(int size)
    {
        for (int i = 0; i < size; i++)
        {
            ref readonly ClusterRow row = ref _rows[i];
            Add(ref Balls[row.First], _x[i], in row.PushV, in row.PushW, row.Held);
            if (row.Second >= 0)
            {
                Add(ref Balls[row.Second], _x[i], in row.OtherPushV, in row.OtherPushW, row.OtherHeld);
            }
        }

        int next = 0;
        for (int i = 0; i < ContactCount; i++)
        {
            ref ClusterContact contact = ref Contacts[i];
            ref SetContact on = ref contact.On;
            on.Load = on.Bears ? _x[next++] : 0;
            on.Friction = default;
            if (on.Bears && on.Sticks)
            {
                on.Friction = (_x[next] * on.First) + (_x[next + 1] * on.Second);
                next += 2;
            }

            contact.Twist = contact.HoldsTwist && on.Bears ? Balls[contact.First].Radius * _x[next++] : 0;
            Vector3d acceleration = Balls[contact.First].Rates.Acceleration;
            acceleration -= contact.Second < 0 ? Vector3d.Zero : Balls[contact.Second].Rates.Acceleration;
            on.Opening = Vector3d.Dot(in on.Normal, in acceleration) + on.Centripetal;
        }
    }

    private static void Add(ref ClusterBall ball, double force, in Vector3d push, in Vector3d turn, double held)
    {
        ball.Rates = new MotionRates(ball.Rates.Acceleration + (force * push), ball.Rates.SpinAcceleration + (force * turn), ball.Rates.AirSpeed);
        ball.HeldSpin += force * held;
    }
}

/// <summary>Room for the equations of a cluster, and for the ways of two balls: nothing of it outlasts a call.</summary>
internal sealed class ClusterRoom
{
    /// <summary>The unknowns.</summary>
    public ClusterRow[] Rows { get; } = new ClusterRow[ClusterSystem.MostRows];

    /// <summary>G x = b: G row by row, x, and b.</summary>
    public double[] G { get; } = new double[ClusterSystem.MostRows * ClusterSystem.MostRows];

    /// <inheritdoc cref="G"/>
    public double[] X { get; } = new double[ClusterSystem.MostRows];

    /// <inheritdoc cref="G"/>
    public double[] Asked { get; } = new double[ClusterSystem.MostRows];

    /// <summary>The ways.</summary>
    public BallTrial Way { get; } = new();

    /// <inheritdoc cref="Way"/>
    public BallTrial OtherWay { get; } = new();
}
