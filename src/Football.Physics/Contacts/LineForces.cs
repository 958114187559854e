namespace FootballPhysics.Contacts;

/// <summary>Loads and friction of a ball on stationary surfaces that confine it to a line a or spot: <see cref="ContactForces"/> in closed
/// form.</summary>
/// <remarks>
/// It applies if no normal turns. The ball has the velocity x a and the spin x e + ψ n, with n the normal of the bearer.
/// The conditions along the line and those across it decouple.
/// With b = n × a, m the normal of the other surface, c = m·n and s = m·b; A and T are the accelerations without contacts.
/// </remarks>
internal unsafe struct LineForces
{
    /// <summary>Value of a margin that no condition uses.</summary>
    private const double Ample = 1.0;

    /// <summary>The contacts that are active, and those that stick.</summary>
    public LineModes Modes;

    /// <summary>n of the bearer, a, and e, 1/m.</summary>
    public Vector3d Normal;
    public Vector3d Along;
    public Vector3d SpinPerSpeed;

    /// <summary>True if rolling resistance or a third surface keeps the ball on its spot.</summary>
    public bool Pinned;

    /// <summary>True if drilling friction holds the spin about n at zero.</summary>
    public bool HoldsSpin;

    /// <summary>Signs of x, of the spin ψ for drilling friction, and of the slip along a.</summary>
    public double Direction;
    public double SpinSign;
    public double SlipSign;

    private Vector3d _across;
    private Vector3d _other;
    private Vector3d _otherAcross;
    private double _cosine;
    private double _sine;
    private double _radius;
    private double _alpha;
    private double _sliding;
    private double _rolling;
    private double _rollingBySpeed;
    private double _damping;
    private double _drilling;
    private double _otherSliding;
    private ThirdSurface _third;

    /// <summary>Prepares one contact that sticks and one that slips: e = b/r.</summary>
    /// <param name="bearer">The contact that sticks.</param>
    /// <param name="other">The other contact.</param>
    /// <param name="ball">The ball.</param>
    /// <returns>False if the normals define no line.</returns>
    public bool Prepare(in Touched bearer, in Touched other, BallProperties ball)
    {
        Vector3d along = Vector3d.Cross(in bearer.Normal, in other.Normal);
        double size = along.Length;
        Modes = LineModes.Roll;
        Pinned = false;
        HoldsSpin = false;
        Normal = bearer.Normal;
        Along = along / size;
        _radius = ball.Radius;
        _alpha = ball.InertiaFactor;
        _across = Vector3d.Cross(in Normal, in Along);
        _other = other.Normal;
        _cosine = Vector3d.Dot(in _other, in Normal);
        _sine = Vector3d.Dot(in _other, in _across);
        SpinPerSpeed = 1.0 / _radius * _across;
        _sliding = bearer.Sliding;
        _rolling = bearer.Rolling;
        _rollingBySpeed = bearer.RollingBySpeed;
        _damping = bearer.Damping;
        _drilling = bearer.Drilling;
        _otherSliding = other.Sliding;
        return size > ContactTolerances.Independent;
    }

    /// <summary>Sets both contacts to stick: e = (b₁ + b₂)/(r (1 + c)), and the ball has no other spin.</summary>
    public void StickBoth()
    {
        Modes = LineModes.Wedge;
        _otherAcross = Vector3d.Cross(in _other, in Along);
        SpinPerSpeed = 1.0 / (_radius * (1.0 + _cosine)) * (_across + _otherAcross);
    }

    /// <summary>Adds an active third surface that blocks the line, so that the ball only spins.</summary>
    /// <remarks>A unit of load has the effect d = m_t − μ (1 − c) t in the plane of n, t = ± m × n/|m × n|.</remarks>
    /// <param name="third">The third contact, which slips like the second one.</param>
    /// <param name="sign">The sign of ψ.</param>
    /// <returns>False if the loads are not determined.</returns>
    public bool Close(in Touched third, double sign)
    {
        Modes = LineModes.Spot;
        Pinned = true;
        Vector3d turn = Vector3d.Cross(in third.Normal, in Normal);
        _third.Cosine = Vector3d.Dot(in third.Normal, in Normal);
        _third.Sine = turn.Length;
        _third.Sliding = third.Sliding;
        _third.Slip = sign / _third.Sine * turn;
        _third.OtherSlip = (_sine < 0 ? -sign : sign) * Along;
        _third.Other = SurfaceSystem.Tangential(in _other, in Normal) - (_otherSliding * (1.0 - _cosine) * _third.OtherSlip);
        _third.Own = SurfaceSystem.Tangential(third.Normal, in Normal) - (third.Sliding * (1.0 - _third.Cosine) * _third.Slip);
        _third.Determinant = Vector3d.Dot(Vector3d.Cross(in _third.Other, in _third.Own), in Normal);
        return Math.Abs(_third.Determinant) > ContactTolerances.Independent && _third.Sine > ContactTolerances.Independent;
    }

    /// <summary>Returns the slip at the second surface along a, (1 − c) x + r s ψ, m/s.</summary>
    public readonly double Slip(double speed, double about) => ((1.0 - _cosine) * speed) + (_radius * _sine * about);

    /// <summary>Returns the magnitude of the slip at the third surface, m/s.</summary>
    public readonly double ThirdSlip(double about) => _radius * _third.Sine * Math.Abs(about);

    /// <summary>Returns the spin about n, rad/s.</summary>
    public readonly double AboutNormal(double speed, double about) => about + (speed * Vector3d.Dot(in SpinPerSpeed, in Normal));

    /// <summary>True if rolling resistance holds a ball at zero speed against a push, m/s² (several.md, Rest).</summary>
    public readonly bool Holds(in Vector3d push, double load) => Math.Abs(Vector3d.Dot(in push, in Along)) <= (1.0 + _alpha) * _rolling * load;

    /// <summary>True if the bearer has drilling friction.</summary>
    public readonly bool Drills => _drilling > 0;

    /// <summary>Computes rates and forces at a state.</summary>
    /// <param name="push">A, m/s².</param>
    /// <param name="torque">T, rad/s².</param>
    /// <param name="speed">x, m/s.</param>
    /// <param name="about">ψ, rad/s.</param>
    /// <param name="rates">Rates, loads, and the margins of the modes.</param>
    public readonly void Evaluate(in Vector3d push, in Vector3d torque, double speed, double about, out LineRates rates)
    {
        switch (Modes)
        {
            case LineModes.Roll:
                Roll(in push, in torque, speed, about, out rates);
                break;
            case LineModes.Spot:
                Spot(in push, in torque, about, out rates);
                break;
            default:
                Wedge(in push, in torque, speed, out rates);
                break;
        }
    }

    /// <summary>One contact sticks: the plane across the line gives the loads, and ẍ = r ω̇·b gives the friction.</summary>
    /// <remarks>N₂ = −(A·b − α r T·a)/s and N₁ = −A·n − c N₂; F (1 + 1/α) = r T·b − A·a + μ N₂ (1 + c/α).</remarks>
    private readonly void Roll(in Vector3d push, in Vector3d torque, double speed, double about, out LineRates rates)
    {
        double along = Vector3d.Dot(in push, in Along);
        double side = -_alpha * _radius * Vector3d.Dot(in torque, in Along);
        double other = -(Vector3d.Dot(in push, in _across) + side) / _sine;
        double load = -Vector3d.Dot(in push, in Normal) - (_cosine * other);
        double rub = SlipSign * _otherSliding * other;
        double grip = _alpha / (1.0 + _alpha) * ((_radius * Vector3d.Dot(in torque, in _across)) - along + (rub * (1.0 + (_cosine / _alpha))));
        double driven = along + grip - rub;
        double spin = Vector3d.Dot(in torque, in Normal) - (_damping * about) - (SpinSign * _drilling * load) - (rub * _sine / (_alpha * _radius));
        rates.Along = Pinned ? 0 : driven - (Resistance(speed) * load);
        rates.About = HoldsSpin ? 0 : spin;
        rates.Load = load;
        rates.Other = other;
        rates.Third = Ample;
        rates.Grip = (_sliding * load) - Math.Sqrt((grip * grip) + (side * side));
        rates.OtherGrip = Ample;
        rates.Hold = Pinned ? (_rolling * load) - Math.Abs(driven) : Ample;
        rates.HoldSpin = HoldsSpin ? (_drilling * load) - Math.Abs(spin) : Ample;
    }

    /// <summary>Three surfaces block every direction: N₂ and N₃ follow from A_t − α r n × T + N₂ d₂ + N₃ d₃ = 0.</summary>
    private readonly void Spot(in Vector3d push, in Vector3d torque, double about, out LineRates rates)
    {
        Vector3d turned = -_alpha * _radius * Vector3d.Cross(in Normal, in torque);
        Vector3d left = SurfaceSystem.Tangential(in push, in Normal) + turned;
        double other = -Vector3d.Dot(Vector3d.Cross(in left, in _third.Own), in Normal) / _third.Determinant;
        double third = -Vector3d.Dot(Vector3d.Cross(in _third.Other, in left), in Normal) / _third.Determinant;
        double load = -Vector3d.Dot(in push, in Normal) - (_cosine * other) - (_third.Cosine * third);
        double rub = _otherSliding * other;
        double thirdRub = _third.Sliding * third;
        Vector3d grip = turned + (rub * _cosine * _third.OtherSlip) + (thirdRub * _third.Cosine * _third.Slip);
        double rubbed = ((rub * Math.Abs(_sine)) + (thirdRub * _third.Sine)) / (_alpha * _radius);
        rates.Along = 0;
        rates.About = Vector3d.Dot(in torque, in Normal) - (_damping * about) - (SpinSign * _drilling * load) - (about < 0 ? -rubbed : rubbed);
        rates.Load = load;
        rates.Other = other;
        rates.Third = third;
        rates.Grip = (_sliding * load) - grip.Length;
        rates.OtherGrip = Ample;
        rates.Hold = Ample;
        rates.HoldSpin = Ample;
    }

    /// <summary>Both contacts stick.</summary>
    /// <remarks>
    /// With loads N, friction P along b and Q along a, P₁ + P₂ = −α r T·a leaves one undetermined force p that pushes the surfaces apart.
    /// It has no effect except through the bearer's resistance. The least-squares solution is used, or the nearest one inside both cones.
    /// </remarks>
    private readonly void Wedge(in Vector3d push, in Vector3d torque, double speed, out LineRates rates)
    {
        double c = _cosine;
        double sine = Vector3d.Dot(in Normal, in _otherAcross);
        double half = -0.5 * _alpha * _radius * Vector3d.Dot(in torque, in Along);
        double first = -Vector3d.Dot(in push, in Normal) - (sine * half);
        double second = -Vector3d.Dot(in push, in _other) + (sine * half);
        double perSquare = 1.0 / (sine * sine);

        // Along the line: S = Q₁ + Q₂ and Δ = Q₁ − Q₂. K is due to rolling resistance and drilling friction.
        double turn = _radius * Vector3d.Dot(in torque, in _across);
        double otherTurn = _radius * Vector3d.Dot(in torque, in _otherAcross);
        double along = Vector3d.Dot(in push, in Along);
        double resistance = Resistance(speed);
        double perLoad = (resistance * (1.0 - c)) - (_radius * SpinSign * _drilling * sine);
        double ofSum = 1.0 / (2.0 + ((1.0 + c) / _alpha));
        double ofDifference = _alpha / (1.0 - c);
        double* x = stackalloc double[6];
        double* z = stackalloc double[6];
        x[0] = (first - (c * second)) * perSquare;
        x[3] = (second - (c * first)) * perSquare;
        x[1] = half;
        x[4] = half;
        double target = (perLoad * x[0]) - (_damping * speed * sine * sine / (1.0 + c));
        SetAlong(x, ofSum * (turn + otherTurn - (2.0 * along) + target), ofDifference * (turn - otherTurn - target));
        z[0] = sine / (1.0 + c);
        z[3] = z[0];
        z[1] = 1.0;
        z[4] = -1.0;
        SetAlong(z, ofSum * perLoad * z[0], -ofDifference * perLoad * z[0]);
        Add(x, z, -Dot(x, z) / Dot(z, z));
        Add(x, z, FrictionBrace.Share(x, z, _sliding, x + 3, z + 3, _otherSliding));
        rates.Along = along + x[2] + x[5] - (resistance * x[0]);
        rates.About = 0;
        rates.Load = x[0];
        rates.Other = x[3];
        rates.Third = Ample;
        rates.Grip = (_sliding * x[0]) - Math.Sqrt((x[1] * x[1]) + (x[2] * x[2]));
        rates.OtherGrip = (_otherSliding * x[3]) - Math.Sqrt((x[4] * x[4]) + (x[5] * x[5]));
        rates.Hold = Ample;
        rates.HoldSpin = Ample;
    }

    /// <summary>Returns the rolling resistance per load, c₀ + c₁ |x|, with the sign of the motion.</summary>
    private readonly double Resistance(double speed) => Direction * (_rolling + (_rollingBySpeed * Math.Abs(speed)));

    private static void SetAlong(double* x, double sum, double difference)
    {
        x[2] = 0.5 * (sum + difference);
        x[5] = 0.5 * (sum - difference);
    }

    private static double Dot(double* x, double* z) => (x[0] * z[0]) + (x[1] * z[1]) + (x[2] * z[2]) + (x[3] * z[3]) + (x[4] * z[4]) + (x[5] * z[5]);

    private static void Add(double* x, double* z, double share)
    {
        for (int i = 0; i < 6; i++)
        {
            x[i] += share * z[i];
        }
    }

    /// <summary>A third surface.</summary>
    private struct ThirdSurface
    {
        public double Cosine;
        public double Sine;
        public double Sliding;
        public double Determinant;

        /// <summary>t at this surface, and at the second one.</summary>
        public Vector3d Slip;
        public Vector3d OtherSlip;

        /// <summary>d of the second surface, and of this one.</summary>
        public Vector3d Other;
        public Vector3d Own;
    }
}

/// <summary>Modes of a contact set that leaves the ball a line.</summary>
internal enum LineModes
{
    /// <summary>The bearer sticks, the other surface slips.</summary>
    Roll,

    /// <summary>Both stick.</summary>
    Wedge,

    /// <summary>The bearer sticks, two others slip, and the ball stays on its spot.</summary>
    Spot,
}

/// <summary>Rates of a ball on a line, its loads, and the margins of the modes, which are positive until a mode ends.</summary>
internal struct LineRates
{
    /// <summary>ẍ, m/s², and ψ̇, rad/s².</summary>
    public double Along;
    public double About;

    /// <summary>N/m of the bearer and the others, m/s².</summary>
    public double Load;
    public double Other;
    public double Third;

    /// <summary>μ N − |F| of the sticking contacts, m/s².</summary>
    public double Grip;
    public double OtherGrip;

    /// <summary>Margins of the rolling resistance and the drilling friction that hold the ball and its spin.</summary>
    public double Hold;
    public double HoldSpin;

    /// <summary>True if the modes hold: all loads and margins are positive.</summary>
    public readonly bool IsValid => Load > ContactTolerances.LeastLoad && Other > ContactTolerances.LeastLoad && Third > ContactTolerances.LeastLoad && Grip > 0 && OtherGrip > 0 && Hold > 0 && HoldSpin > 0;

    /// <summary>True if every load and margin keeps a share of its value at the start.</summary>
    public readonly bool Keeps(in LineRates start, double share) =>
        Load > share * start.Load && Other > share * start.Other && Third > share * start.Third && Grip > share * start.Grip && OtherGrip > share * start.OtherGrip
        && Hold > share * start.Hold && HoldSpin > share * start.HoldSpin;
}
