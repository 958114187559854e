namespace FootballPhysics.Integration;

/// <summary>A Runge–Kutta method of high order, for motion that changes fast but smoothly: a ball in a net.</summary>
/// <remarks>
/// Row i of the tableau has weights for stage 0 and for the stages from its first one up to i − 1; all others are zero. The last stage is at the end.
/// </remarks>
internal sealed unsafe class HighOrder
{
    /// <summary>Order 6 in 7 stages, by Butcher.</summary>
    public static readonly HighOrder Sixth = new(
        [0, 1.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0, 0.5, 0.5, 1],
        [0, 1, 1, 1, 1, 1, 1, 2],
        [
            1.0 / 3.0,
            0, 2.0 / 3.0,
            1.0 / 12.0, 1.0 / 3.0, -1.0 / 12.0,
            -1.0 / 16.0, 9.0 / 8.0, -3.0 / 16.0, -3.0 / 8.0,
            0, 9.0 / 8.0, -3.0 / 8.0, -3.0 / 4.0, 0.5,
            9.0 / 44.0, -9.0 / 11.0, 63.0 / 44.0, 18.0 / 11.0, 0, -16.0 / 11.0,
            11.0 / 120.0, 27.0 / 40.0, 27.0 / 40.0, -4.0 / 15.0, -4.0 / 15.0, 11.0 / 120.0,
        ]);

    /// <summary>Order 8 in 12 stages: DOP853 by Dormand and Prince (Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, second
    /// edition, II.5).</summary>
    public static readonly HighOrder Eighth = new(
        [
            0, 0.0526001519587677318785587544488, 0.0789002279381515978178381316732, 0.11835034190722739672675719751, 0.28164965809277260327324280249,
            0.333333333333333333333333333333, 0.25, 0.307692307692307692307692307692, 0.651282051282051282051282051282, 0.6, 0.857142857142857142857142857142, 1,
        ],
        [0, 1, 1, 2, 2, 3, 3, 3, 3, 3, 3, 3, 5],
        [
            5.26001519587677318785587544488e-2,
            1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2,
            2.95875854768068491816892993775e-2, 8.87627564304205475450678981324e-2,
            2.41365134159266685502369798665e-1, -8.84549479328286085344864962717e-1, 9.24834003261792003115737966543e-1,
            3.7037037037037037037037037037e-2, 1.70828608729473871279604482173e-1, 1.25467687566822425016691814123e-1,
            3.7109375e-2, 1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2, -1.7578125e-2,
            3.70920001185047927108779319836e-2, 1.70383925712239993810214054705e-1, 1.07262030446373284651809199168e-1, -1.53194377486244017527936158236e-2, 8.27378916381402288758473766002e-3,
            6.24110958716075717114429577812e-1, -3.36089262944694129406857109825, -8.68219346841726006818189891453e-1, 2.75920996994467083049415600797e1, 2.01540675504778934086186788979e1, -4.34898841810699588477366255144e1,
            4.77662536438264365890433908527e-1, -2.48811461997166764192642586468, -5.90290826836842996371446475743e-1, 2.12300514481811942347288949897e1, 1.52792336328824235832596922938e1, -3.32882109689848629194453265587e1, -2.03312017085086261358222928593e-2,
            -9.3714243008598732571704021658e-1, 5.18637242884406370830023853209, 1.09143734899672957818500254654, -8.14978701074692612513997267357, -1.85200656599969598641566180701e1, 2.27394870993505042818970056734e1, 2.49360555267965238987089396762, -3.0467644718982195003823669022,
            2.27331014751653820792359768449, -1.05344954667372501984066689879e1, -2.00087205822486249909675718444, -1.79589318631187989172765950534e1, 2.79488845294199600508499808837e1, -2.85899827713502369474065508674, -8.87285693353062954433549289258, 1.23605671757943030647266201528e1, 6.43392746015763530355970484046e-1,
            5.42937341165687622380535766363e-2, 4.45031289275240888144113950566, 1.89151789931450038304281599044, -5.8012039600105847814672114227, 3.1116436695781989440891606237e-1, -1.52160949662516078556178806805e-1, 2.01365400804030348374776537501e-1, 4.47106157277725905176885569043e-2,
        ]);

    /// <summary>The weights of the stages of <see cref="Eighth"/> in an estimate of its error of order 5 (ER of DOP853).</summary>
    public static readonly double[] FifthError =
    [
        0.1312004499419488073250102996e-1, 0, 0, 0, 0, -0.1225156446376204440720569753e1, -0.4957589496572501915214079952, 0.1664377182454986536961530415e1,
        -0.3503288487499736816886487290, 0.3341791187130174790297318841, 0.8192320648511571246570742613e-1, -0.2235530786388629525884427845e-1,
    ];

    /// <summary>The same of order 3 (B − BHH).</summary>
    public static readonly double[] ThirdError = Eighth.EndLess(0.244094488188976377952755905512, 0.733846688281611857341361741547, 0.220588235294117647058823529412e-1);

    /// <summary>The maximum number of stages.</summary>
    private const int Most = 12;

    private readonly double[] _nodes;
    private readonly int[] _firstOfRow;
    private readonly double[] _weights;

    private HighOrder(double[] nodes, int[] firstOfRow, double[] weights)
    {
        _nodes = nodes;
        _firstOfRow = firstOfRow;
        _weights = weights;
    }

    /// <summary>The number of evaluations per step, including that at the start.</summary>
    public int Stages => _nodes.Length;

    /// <summary>Takes a step.</summary>
    /// <param name="system">The system that computes the rates.</param>
    /// <param name="time">The time at the start, in s.</param>
    /// <param name="from">The motion at the start.</param>
    /// <param name="start">The rates at the start: the first stage.</param>
    /// <param name="h">The length of the step, in s.</param>
    /// <param name="turnsByStages">True if the rotation has the order of the method, and not only that of a cubic through both ends.</param>
    /// <param name="step">The result of the step.</param>
    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, bool turnsByStages, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        Stage* stages = stackalloc Stage[Most];
        stages[0].Velocity = from.Velocity;
        stages[0].Spin = from.Spin;
        stages[0].Rates = start;
        double[] weights = _weights;
        int count = Stages;
        int next = 0;
        Motion at = from;
        for (int i = 1; ; i++)
        {
            // y + h Σ w k; the rates of the position are the velocities.
            double w = h * weights[next++];
            Vector3d velocity = w * stages[0].Velocity;
            Vector3d acceleration = w * stages[0].Rates.Acceleration;
            Vector3d spinAcceleration = w * stages[0].Rates.SpinAcceleration;
            double airSpeed = w * stages[0].Rates.AirSpeed;
            Vector3d turning = w * stages[0].Rates.Turning;
            for (int j = _firstOfRow[i]; j < i; j++)
            {
                w = h * weights[next++];
                velocity += w * stages[j].Velocity;
                acceleration += w * stages[j].Rates.Acceleration;
                spinAcceleration += w * stages[j].Rates.SpinAcceleration;
                airSpeed += w * stages[j].Rates.AirSpeed;
                turning += w * stages[j].Rates.Turning;
            }

            at = new Motion(from.Position + velocity, from.Velocity + acceleration, from.Spin + spinAcceleration, from.AirDistance + airSpeed, from.Turn + turning);
            if (i == count)
            {
                break;
            }

            stages[i].Velocity = at.Velocity;
            stages[i].Spin = at.Spin;
            system.Rates(time + (_nodes[i] * h), in at, out stages[i].Rates);
        }

        // The spin at the middle, from the cubic through both ends, because the last stage is at the end.
        Vector3d middle = (0.5 * (from.Spin + at.Spin)) + (0.125 * h * (start.SpinAcceleration - stages[count - 1].Rates.SpinAcceleration));
        if (turnsByStages)
        {
            // With this spin at the middle, Simpson's rule returns the mean of the stages.
            middle = (1.5 * MeanSpin(stages)) - (0.25 * (from.Spin + at.Spin));
        }

        step.End = at;
        step.Rotation = RotationVector.Of(in from.Spin, in middle, in at.Spin, h);
        step.StartRates = start;
    }

    /// <summary>Returns the weights of the end, less those of a method that uses the stages 0, 8 and 11.</summary>
    private double[] EndLess(double first, double ninth, double last)
    {
        double[] less = new double[Stages];
        int begin = _firstOfRow[Stages];
        int row = _weights.Length - 1 - (Stages - begin);
        less[0] = _weights[row] - first;
        for (int i = begin; i < Stages; i++)
        {
            less[i] = _weights[row + 1 + i - begin];
        }

        less[8] -= ninth;
        less[11] -= last;
        return less;
    }

    /// <summary>Returns the mean of the spin in a step, by the weights of its end.</summary>
    private Vector3d MeanSpin(Stage* stages)
    {
        int begin = _firstOfRow[Stages];
        int row = _weights.Length - 1 - (Stages - begin);
        Vector3d mean = _weights[row] * stages[0].Spin;
        for (int i = begin; i < Stages; i++)
        {
            mean += _weights[row + 1 + i - begin] * stages[i].Spin;
        }

        return mean;
    }

    /// <summary>The rates at a stage: the velocity is that of the position.</summary>
    private struct Stage
    {
        public Vector3d Velocity;
        public Vector3d Spin;
        public MotionRates Rates;
    }
}
