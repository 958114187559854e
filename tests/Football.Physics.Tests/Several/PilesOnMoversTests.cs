using FootballPhysics.Tests.Things;

namespace FootballPhysics.Tests.Several;

/// <summary>Balls that lean on an object that a game, an engine or an impact may move: they rest while it stands still, and only then.</summary>
public sealed class PilesOnMoversTests
{
    private const double Frame = 1.0 / 60;

    public static TheoryData<string> Kinds => ["body", "engine", "obstacle"];

    /// <summary>The wind presses two balls in a row against an object that stands still: both rest, and later steps tell nothing and change only the time.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void Balls_that_lean_on_an_object_that_stands_still_come_to_rest(string kind)
    {
        var row = new Row(kind);
        row.Step(600);
        Assert.All(row.Balls, ball => Assert.True(ball.Motion == MotionState.Rest && ball.Velocity == Vector3d.Zero, ball.ToString()));
        Assert.True(row.Gap < 1e-6 && row.Apart < 1e-6, "The balls lean on nothing.");
        BallState[] before = [.. row.Balls];
        row.Log.Clear();
        row.Step(60);
        Assert.Equal(0, row.Log.Events.Count);
        Assert.Equal(before.Select(ball => ball.Position), row.Balls.Select(ball => ball.Position));
        Assert.InRange(row.Log.Evaluations, 0, 3 * 60 * 2);
    }

    /// <summary>The object is taken away, begins to move off, or moves along its surface: the balls are not held any more.</summary>
    [Theory]
    [InlineData("body", 0, -3, 0)]
    [InlineData("engine", 0, -3, 0)]
    [InlineData("body", 0, 0, -0.5)]
    [InlineData("engine", 0, 0, -0.5)]
    [InlineData("body", 3, 0, 0)]
    [InlineData("engine", 3, 0, 0)]
    public void Balls_that_leaned_on_an_object_move_when_it_does(string kind, double x, double z, double speed)
    {
        var row = new Row(kind);
        row.Step(600);
        Vector3d[] before = [.. row.Balls.Select(ball => ball.Position)];
        row.Place += new Vector3d(x, 0, z);
        row.Velocity = new Vector3d(0, 0, speed);
        row.Step(60);
        Assert.All(row.Balls.Zip(before), pair => Assert.InRange(pair.Second.Z - pair.First.Position.Z, 0.1, 5));
    }

    /// <summary>Two balls on the ground in a wind towards −z, and an object in their way.</summary>
    private sealed class Row
    {
        private readonly PosedCollider? _object;
        private readonly BallGroup _group;
        private readonly IShape _shape = new BoxShape(new Vector3d(0, 1, -0.2), new Vector3d(1, 1, 0.2));

        public Row(string kind)
        {
            Scene scene = Scene.Default with { Air = new Air { Wind = new Vector3d(0, 0, -20) }, Forces = ForceSet.Measured };
            if (kind == "obstacle")
            {
                scene = scene with { Obstacles = [new Obstacle { Name = "object", Shape = _shape, Mass = 80 }] };
            }
            else
            {
                _object = PosedCollider.In(ref scene, _shape, SurfaceMaterial.Wood, kind == "engine");
            }

            var simulator = new Simulator(scene);
            _group = new BallGroup(simulator, 2);
            Radius = scene.Ball.Radius;

            // An obstacle that a ball hits would go on for ever.
            double gap = kind == "obstacle" ? 0 : 0.001;
            Balls = [.. new[] { gap, (2 * Radius) + (10 * gap) }.Select(z => simulator.Launch(new Vector3d(10 * gap * z, simulator.ContactHeight, Radius + z), Vector3d.Zero, Vector3d.Zero))];
        }

        public BallState[] Balls { get; }

        public StepLog Log { get; } = new();

        public Vector3d Place { get; set; }

        public Vector3d Velocity { get; set; }

        /// <summary>Between the first ball and the object where it stood at first, and between the balls, m.</summary>
        public double Gap => Math.Abs(_shape.At(Balls[0].Position).Distance - Radius);

        public double Apart => Math.Abs((Balls[1].Position - Balls[0].Position).Length - (2 * Radius));

        private double Radius { get; }

        public void Step(int frames)
        {
            for (int k = 0; k < frames; k++)
            {
                _object?.MoveTo(Place, Quaterniond.Identity, Velocity, Vector3d.Zero, Balls[0].Time);
                _group.Step(Balls, Frame, Log);
                Place += Frame * Velocity;
            }
        }
    }
}
