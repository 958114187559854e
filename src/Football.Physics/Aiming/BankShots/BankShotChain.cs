namespace Football.Physics;

/// <summary>
/// Finds the kick and the places of its contacts such that every leg ends where the next begins: multiple shooting, by Newton's method from a guess. The derivatives are
/// measured, and kept by Broyden's updates as long as that gets closer.
/// </summary>
/// <remarks>
/// The kicks that meet a post are a hair's breadth of elevations and azimuths, but a post's whole side of places: in these unknowns Newton's method comes from far.
/// </remarks>
internal sealed class BankShotChain
{
    private const int MostSteps = 16;

    /// <summary>A step is tried so often; one that leads to no smaller gap is shortened to this share of it.</summary>
    private const int MostTries = 5;
    private const double Shorter = 0.35;

    /// <summary>A gap that is not this much smaller after a step calls for new derivatives.</summary>
    private const double Progress = 0.25;

    /// <summary>What a radian of the kick is worth in metres of a contact: for Broyden's updates.</summary>
    private const double MetresPerRadian = 10;

    /// <summary>A chain whose gaps are all below this is closed by one more step, m.</summary>
    private const double Closed = 3e-3;

    /// <summary>The most that a step turns the kick, or the normal of a contact, rad; and of the length of the leg to it, that it moves a contact.</summary>
    private const double LargestTurn = 0.3;
    private const double LargestBend = 0.6;
    private const double LargestShare = 0.5;

    /// <summary>The time of a leg changes by this factor at most.</summary>
    private const double LargestChange = 2;

    private readonly double _radius;
    private double[] _savedTimes = [];
    private double[] _savedLate = [];
    private BankShotContact[] _savedContacts = [];
    private Kick _savedKick;
    private double[] _savedGaps = [];
    private double[] _system = [];
    private double[] _step = [];
    private double[] _weight = [];

    public BankShotChain(Scene scene)
    {
        Legs = new BankShotLegs(scene);
        _radius = scene.Ball.Radius;
    }

    /// <summary>The legs.</summary>
    public BankShotLegs Legs { get; }

    /// <summary>Makes room for a number of contacts.</summary>
    public void Prepare(int count)
    {
        Legs.Prepare(count);
        int unknowns = Legs.Unknowns;
        if (_step.Length < unknowns)
        {
            _savedTimes = new double[count + 1];
            _savedLate = new double[count + 1];
            _savedContacts = new BankShotContact[count];
            _savedGaps = new double[unknowns];
            _system = new double[unknowns * (unknowns + 1)];
            _step = new double[unknowns];
            _weight = new double[unknowns];
        }
    }

    /// <summary>Closes the chain by Newton's method from where its contacts and its kick are.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="frame">Ball and target.</param>
    /// <param name="counts">Where flights and corrections are counted.</param>
    /// <returns>False where it does not come together.</returns>
    public bool Close(AimRequest request, in TargetFrame frame, BankShotFlight counts)
    {
        // 1. All legs are flown, and their derivatives measured. 2. Newton's step for the kick and all places; shortened until the widest gap shrinks.
        // 3. While it shrinks fast the derivatives are updated, else measured again. 4. Below a few millimetres one more step closes it, not flown.
        Array.Clear(Legs.Times, 0, Legs.Count + 1);
        bool isFresh = true;
        if (!Legs.Fly(request, in frame, measures: true, counts))
        {
            return false;
        }

        for (int i = 0; i < Math.Min(MostSteps, request.MaximumIterations); i++)
        {
            counts.Iterations++;
            if (!Solve())
            {
                return false;
            }

            double last = Legs.Gap;
            Save();
            bool better = false;
            for (int tries = 0; tries < (isFresh ? MostTries : 1) && !better; tries++)
            {
                Restore();
                better = Take(tries == 0 ? 1.0 : Shorter, request.Speed) && Legs.Fly(request, in frame, measures: false, counts) && Legs.Gap < last;
            }

            if (!better && isFresh)
            {
                return false;
            }

            if (better && Legs.Gap < Closed)
            {
                // The last step is not flown.
                Update();
                return Solve() && Take(1.0, request.Speed);
            }

            if (better && Legs.Gap < Progress * last)
            {
                Update();
                isFresh = false;
                continue;
            }

            if (!better)
            {
                Restore();
            }

            isFresh = true;
            if (!Legs.Fly(request, in frame, measures: true, counts))
            {
                return false;
            }
        }

        return false;
    }

    /// <summary>Broyden's update of the derivatives by what the last step did, of each row by what it depends on.</summary>
    private void Update()
    {
        int n = Legs.Unknowns;
        for (int row = 0; row < n; row++)
        {
            int last = Math.Min(n, (row & ~1) + 4);
            double squared = 0;
            for (int j = 0; j < last; j++)
            {
                _weight[j] = j < 2 ? MetresPerRadian * MetresPerRadian : 1.0;
                squared += _weight[j] * _step[j] * _step[j];
            }

            Broyden.Update(Legs.Rows, row * n, last, _step, _weight, squared, Legs.Gaps[row] - _savedGaps[row]);
        }
    }

    /// <summary>Newton's step.</summary>
    private bool Solve()
    {
        int n = Legs.Unknowns;
        for (int i = 0; i < n; i++)
        {
            Array.Copy(Legs.Rows, i * n, _system, i * (n + 1), n);
            _system[(i * (n + 1)) + n] = -Legs.Gaps[i];
        }

        return Linear.Solve(_system, _step, n);
    }

    /// <summary>Remembers where the unknowns are, and the gaps there.</summary>
    private void Save()
    {
        int legs = Legs.Count + 1;
        _savedKick = Legs.Kick;
        Array.Copy(Legs.Times, _savedTimes, legs);
        Array.Copy(Legs.Late, _savedLate, legs);
        Array.Copy(Legs.Contacts, _savedContacts, Legs.Count);
        Array.Copy(Legs.Gaps, _savedGaps, Legs.Unknowns);
    }

    /// <summary>Goes back there.</summary>
    private void Restore()
    {
        int legs = Legs.Count + 1;
        Legs.Kick = _savedKick;
        Array.Copy(_savedTimes, Legs.Times, legs);
        Array.Copy(_savedLate, Legs.Late, legs);
        Array.Copy(_savedContacts, Legs.Contacts, Legs.Count);
    }

    /// <summary>Takes a share of the step, or what of it is not too large; the step is then that.</summary>
    private bool Take(double most, double speed)
    {
        // No farther than the kick may turn, a normal bend, and a place move of its leg: beyond that the derivatives tell nothing.
        int unknowns = Legs.Unknowns;
        double share = most / Math.Max(1.0, most * Math.Sqrt((_step[0] * _step[0]) + (_step[1] * _step[1])) / LargestTurn);
        for (int i = 0; i < Legs.Count; i++)
        {
            ref BankShotContact contact = ref Legs.Contacts[i];
            Vector3d move = Move(i);
            double bend = (contact.Curvature * move).Length;
            double far = move.Length / Math.Max(0.1, Legs.Times[i] * speed);
            share = Math.Min(share, most / Math.Max(1.0, most * Math.Max(bend / LargestBend, far / LargestShare)));
        }

        if (!(share > 0))
        {
            return false;
        }

        for (int j = 0; j < unknowns; j++)
        {
            _step[j] *= share;
        }

        for (int leg = 0; leg <= Legs.Count; leg++)
        {
            // A leg's own delay is made up for at once, and what the step will add to it.
            double late = most * Legs.Late[leg];
            for (int j = 0; j < unknowns; j++)
            {
                late += Legs.LateBy[(leg * unknowns) + j] * _step[j];
            }

            double shortest = Math.Max(BankShotLegs.ShortestLeg, Legs.Times[leg] / LargestChange);
            double longest = Math.Min(BankShotLegs.LongestLeg, LargestChange * Legs.Times[leg]);
            Legs.Times[leg] = Math.Min(longest, Math.Max(shortest, Legs.Times[leg] + late));
        }

        Kick kick = Legs.Kick;
        kick.Elevation = Math.Min(0.5 * Math.PI, Math.Max(-0.5 * Math.PI, kick.Elevation + _step[0]));
        kick.Azimuth += _step[1];
        Legs.Kick = kick;
        for (int i = 0; i < Legs.Count; i++)
        {
            Legs.Contacts[i].GoTo(Legs.Contacts[i].Place + Move(i), _radius);
        }

        return true;
    }

    private Vector3d Move(int contact) => (_step[(2 * contact) + 2] * Legs.Contacts[contact].Level) + (_step[(2 * contact) + 3] * Legs.Contacts[contact].Steep);
}
