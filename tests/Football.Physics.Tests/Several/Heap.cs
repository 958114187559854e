using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Several;

/// <summary>Balls that are dropped onto each other within walls, and what is measured of them: depth in what stands still, overlap, energy, counts.</summary>
internal sealed class Heap
{
    /// <summary>Dry turf, and boards that are less lively.</summary>
    public static readonly Ground Turf = Ground.Of(SurfaceMaterial.DryTurf);

    public static readonly SurfaceMaterial Board = SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = 0.5,
        RestitutionSpeedScale = 1e9,
        TangentialRestitution = 0.3,
        SpinRestitution = 0.8,
        ImpactFriction = 0.35,
        SlidingFriction = 0.35,
        RollingResistance = 0.03,
        SpinDamping = 0.002,
    };

    private readonly Scene _scene;
    private readonly BallProperties[] _kinds;
    private double _energy;

    public Heap(Scene scene, BallProperties[] kinds, Vector3d[] places, SurfaceMaterial? contact = null)
    {
        _scene = scene;
        _kinds = kinds;
        Group = new BallGroup(scene, kinds, contact: contact);
        Balls = [.. places.Select((place, i) => Group.SimulatorOf(i).Launch(place, default, default))];
        _energy = Energy();
    }

    public BallGroup Group { get; }

    public BallState[] Balls { get; }

    public StepLog Log { get; } = new(mostEvents: 200_000);

    /// <summary>The most that any ball was in a plane or in the ground, and in another ball, m; and what energy a step gave, J.</summary>
    public double Depth { get; private set; }

    public double Overlap { get; private set; }

    public double Gain { get; private set; }

    public int Steps { get; private set; }

    public bool Rests => Array.TrueForAll(Balls, ball => ball.Motion == MotionState.Rest);

    public double EvaluationsPerBall => Log.Evaluations / (double)(Balls.Length * Steps);

    /// <summary>Walls around a square, infinitely high.</summary>
    public static Scene Box(double half) => Scene.Default with { Ground = Turf, Obstacles = [Wall(half, 0), Wall(-half, 0), Wall(0, half), Wall(0, -half)] };

    /// <summary>Two walls that meet.</summary>
    public static Scene Corner() => Scene.Default with { Ground = Turf, Obstacles = [Wall(-0.3, 0), Wall(0, -0.3)] };

    public static Obstacle Wall(double x, double z) => new()
    {
        Name = $"wall {x} {z}",
        Shape = new PlaneShape(new Vector3d(x, 0, z), new Vector3d(-x, 0, -z)),
        Surface = Board,
    };

    /// <summary>Balls dropped one above the other.</summary>
    public static Heap Dropped(Scene scene, int count, double aside, double first, double apart, int seed, BallProperties[]? kinds = null)
    {
        var random = new Random(seed);
        BallProperties[] all = [.. Enumerable.Range(0, count).Select(i => kinds is null ? BallProperties.Tunnel : kinds[i % kinds.Length])];
        return new Heap(scene, all, [.. Enumerable.Range(0, count).Select(i =>
            new Vector3d(((2 * random.NextDouble()) - 1) * aside, first + (apart * i), ((2 * random.NextDouble()) - 1) * aside))]);
    }

    public void Run(double step, double duration, bool untilRest = false)
    {
        double end = Balls[0].Time + duration - (1e-6 * step);
        while (Balls[0].Time < end && !(untilRest && Rests))
        {
            Step(step);
        }
    }

    public void Step(double step)
    {
        Group.Step(Balls, step, Log);
        Steps++;
        double energy = Energy();
        Gain = Math.Max(Gain, energy - _energy);
        _energy = energy;
        for (int i = 0; i < Balls.Length; i++)
        {
            foreach (Collider collider in Group.SimulatorOf(i).World.Colliders.Where(collider => !collider.Moves))
            {
                Depth = Math.Max(Depth, _kinds[i].Radius - collider.At(Balls[i].Position, Balls[i].Time).Distance);
            }

            for (int j = 0; j < i; j++)
            {
                Overlap = Math.Max(Overlap, _kinds[i].Radius + _kinds[j].Radius - (Balls[i].Position - Balls[j].Position).Length);
            }
        }
    }

    public double Energy() => Balls.Select((ball, i) =>
        (0.5 * _kinds[i].Mass * ball.Velocity.LengthSquared) + (0.5 * _kinds[i].MomentOfInertia * ball.Spin.LengthSquared)
        - (_kinds[i].Mass * Weight.UpwardAcceleration(_scene with { Ball = _kinds[i] }) * ball.Position.Y)).Sum();
}
