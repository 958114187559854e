using FootballPhysics.Netcode;
using FootballPhysics.Shapes;

namespace FootballPhysics.Peers;

/// <summary>Balls of this library: one <see cref="Ball"/> each, with all its air unless the experiment has none.</summary>
public sealed class FootballWorld : IPeerWorld<BallState>
{
    private readonly List<Ball> _balls = [];
    private readonly Simulator _simulator;

    public FootballWorld(PeerOptions options)
    {
        SurfaceMaterial material = SurfaceMaterial.PublishedTurf with { NormalRestitution = Harness.Restitution };
        if (options.Rolling)
        {
            material = material with { RollingResistance = 1 / Harness.Gravity, RollingResistancePerSpeed = 0 };
        }

        var scene = new Scene { Ground = Ground.PublishedTurf with { Material = material } };
        if (options.Vacuum)
        {
            scene = scene with { Forces = ForceSet.None };
        }

        if (options.Post)
        {
            var shape = new CapsuleShape(new Vector3d(0, 0, Harness.PostZ), new Vector3d(0, Harness.PostHeight, Harness.PostZ), Harness.PostRadius);
            scene = scene with { Obstacles = [new Obstacle { Name = "post", Shape = shape }] };
        }

        _simulator = new Simulator(scene);
    }

    public void Add(Vector3d position, Vector3d velocity, Vector3d spin)
    {
        var ball = new Ball(_simulator);
        ball.Launch(position, velocity, spin);
        _balls.Add(ball);
    }

    public void Step(double h)
    {
        foreach (Ball ball in _balls)
        {
            ball.Step(h);
        }
    }

    public BallState Save(int ball) => _balls[ball].State;

    public void Restore(int ball, in BallState state) => _balls[ball].State = state;

    public Vector3d Position(int ball) => _balls[ball].Position;

    public Vector3d Velocity(int ball) => _balls[ball].Velocity;

    public ulong Hash(int ball) => Snapshot.Hash(_balls[ball].State);
}
