using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <content>The forces of the contacts: one linear system for all of them.</content>
internal sealed partial class ClusterSystem
{
    /// <summary>Solves the contact forces, and with them the rates.</summary>
    /// <returns>False if no forces satisfy all conditions.</returns>
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
            _target[i] = row.Target - Along(in row);
            _x[i] = _target[i];
            largest = Math.Max(largest, Math.Abs(_target[i]));
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

    /// <summary>Computes the rates without contacts, including the bearer's damping and a spin held by drilling friction.</summary>
    private void SetFree(ref ClusterBall ball)
    {
        Vector3d spin = ball.Free.SpinAcceleration;
        if (ball.Bearer >= 0)
        {
            // ω̇_n = −(c_ω/I) (ω − Ω)·n. If friction holds the spin, d(ω·n)/dt = ω̇·n + ω·ṅ stays zero.
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
        load.Target = -on.Centripetal;
        Push(ref load, in n, on.Sticks ? default : -on.Sliding * on.SlipDirection, in n);
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
            // The slip rate: t·(v̇₁ − v̇₂ + n × (r₁ ω̇₁ + r₂ ω̇₂)) = t·(A − ṅ × (r₁ ω₁ + r₂ ω₂)).
            Vector3d turning = ball.Radius * ball.At.Spin;
            turning += contact.Second < 0 ? Vector3d.Zero : Balls[contact.Second].Radius * Balls[contact.Second].At.Spin;
            Vector3d target = on.SurfaceRate - Vector3d.Cross(in on.Turning, in turning);
            AddStick(ref Begin(size++, in contact), in n, in on.First, in target);
            AddStick(ref Begin(size++, in contact), in n, in on.Second, in target);
        }

        if (contact.HoldsTwist)
        {
            // n·(ω̇₁ − ω̇₂) = −ṅ·(ω₁ − ω₂). The unknown is the torque divided by r₁, so it has the unit of a force.
            ref readonly ClusterBall other = ref Balls[contact.Second];
            ref ClusterRow twist = ref Begin(size++, in contact);
            twist.AlongW = ball.Radius * n;
            twist.OtherAlongW = -ball.Radius * n;
            twist.Target = -ball.Radius * Vector3d.Dot(in on.Turning, ball.At.Spin - other.At.Spin);
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

    private void AddStick(ref ClusterRow row, in Vector3d n, in Vector3d along, in Vector3d target)
    {
        Vector3d turned = Vector3d.Cross(in along, in n);
        row.AlongV = along;
        row.AlongW = Balls[row.First].Radius * turned;
        row.Target = Vector3d.Dot(in target, in along);
        if (row.Second >= 0)
        {
            row.OtherAlongV = -along;
            row.OtherAlongW = Balls[row.Second].Radius * turned;
        }

        Push(ref row, default, in along, in n);
    }

    /// <summary>Sets a force on the first ball and the opposite one on the second: along the normal, and along the surface, which turns
    /// both.</summary>
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

    /// <summary>Adds rolling resistance (c₀ + c₁|v|) N/m against the motion, and drilling friction b μ_s N/I against the spin about the
    /// normal.</summary>
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

    /// <summary>Removes the part of a force that drilling friction takes if it holds a ball's spin.</summary>
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

    /// <summary>Returns the left side of a condition without contact forces.</summary>
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

    /// <summary>Returns the response of a condition to a unit of a force.</summary>
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

    /// <summary>True if forces that are not unique satisfy all conditions.</summary>
    private bool Meets(int size, double largest)
    {
        for (int i = 0; i < size; i++)
        {
            double left = _target[i];
            for (int j = 0; j < size; j++)
            {
                left -= _g[(i * size) + j] * _x[j];
            }

            if (!(Math.Abs(left) <= ContactTolerances.SolvedForces * largest))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Applies the forces to the balls, and stores the loads of the contacts.</summary>
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
