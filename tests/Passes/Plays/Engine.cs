using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using Numbers = System.Numerics;

namespace FootballPhysics.Passes.Plays;

/// <summary>The colliders of a game engine: with shapes that the library has and without, at rest and moving, with masses and layers.</summary>
internal static class Engine
{
    private const double Frame = 1.0 / 60;

    public static void Play()
    {
        var draw = new Draw(11);
        for (int i = 0; i < 80; i++)
        {
            World world = Made(draw);
            var simulator = new Simulator(draw.Any(Scene.Default, Scene.Published) with { EngineColliders = world, Ball = BallProperties.Modern with { Ignores = draw.Chance(0.2) ? Layers.Of(3) : 0 } });
            var log = new StepLog();
            BallState ball = simulator.Launch(new Vector3d(0, draw.Any(0.11, 1), 0), draw.Between(1, 20) * draw.Heading(), draw.Vector(20));
            for (int tick = 0; tick < 300; tick++)
            {
                world.Time = ball.Time;
                Show(in ball);
                simulator.Step(ref ball, Frame, log);
                foreach (ref readonly BallEvent happened in log.Events)
                {
                    _ = simulator.NameOf(happened.ColliderIndex);
                }

                log.Clear();
                if (ball.Motion == MotionState.Rest)
                {
                    simulator.Kick(ref ball, draw.Between(1, 20) * draw.Heading(), default);
                }
            }
        }

        for (int i = 0; i < 25; i++)
        {
            World world = Made(draw);
            var group = new BallGroup(new Simulator(Scene.Default with { EngineColliders = world }), 3);
            BallState[] states = [.. Enumerable.Range(0, 3).Select(at => group.SimulatorOf(at).Launch(new Vector3d(0.3 * at, 0.11 + (0.3 * at), 0), draw.Vector(10), default))];
            var log = new StepLog();
            for (int tick = 0; tick < 240; tick++)
            {
                world.Time = states[0].Time;
                group.Step(states, Frame, log);
            }
        }
    }

    // An engine has vectors of its own, in float.
    private static void Show(in BallState ball)
    {
        Numbers.Vector3 place = ball.Position.ToVector3();
        Numbers.Quaternion pose = ball.Orientation.ToQuaternion();
        _ = ((Vector3d)place).X + ((Numbers.Vector3)ball.Velocity).X + ((Quaterniond)pose).SpinTo(ball.Orientation, Frame).X;
    }

    private static World Made(Draw draw)
    {
        var world = new World();
        int count = 1 + draw.Below(6);
        for (int i = 0; i < count; i++)
        {
            Vector3d at = draw.Between(0.4, 3) * draw.Heading();
            IShape shape = draw.Below(4) switch
            {
                0 => new BoxShape(at + new Vector3d(0, 0.5, 0), new Vector3d(0.4, 0.5, 0.2)),
                1 => new CapsuleShape(at, at + new Vector3d(0, 1.5, 0), 0.2),
                2 => new SphereShape(at + new Vector3d(0, 0.2, 0), 0.3),
                _ => new PlaneShape(at, -at.Normalized()),
            };
            world.Add(draw, shape, i);
        }

        return world;
    }

    private sealed class World : IEngineColliders
    {
        private readonly List<(EngineCollider Collider, IShape Shape, Vector3d Velocity, bool IsKnown)> _all = [];

        public double Time { get; set; }

        public double MaximumSpeed { get; private set; }

        public void Add(Draw draw, IShape shape, int number)
        {
            bool isKnown = draw.Chance(0.6);
            double mass = draw.Chance(0.3) ? draw.Any(1.0, 30) : double.PositiveInfinity;
            EngineCollider collider = isKnown
                ? new EngineCollider($"thing {number}", shape, draw.Any(SurfaceMaterial.Board, SurfaceMaterial.Wood)) { Mass = mass }
                : new EngineCollider($"thing {number}") { Mass = mass };
            collider.Layer = draw.Below(5);
            Vector3d velocity = draw.Chance(0.4) && shape is not PlaneShape ? draw.Between(0.1, 2) * draw.Heading() : default;
            MaximumSpeed = Math.Max(MaximumSpeed, velocity.Length);
            _all.Add((collider, shape, velocity, isKnown));
        }

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            foreach ((EngineCollider collider, IShape shape, Vector3d velocity, bool isKnown) in _all)
            {
                Vector3d gone = Time * velocity;
                Vector3d nearest = cast.From;
                for (int i = 0; i <= 20; i++)
                {
                    Vector3d at = cast.From + (cast.Distance * i / 20 * cast.Direction);
                    nearest = shape.At(at - gone).Distance < shape.At(nearest - gone).Distance ? at : nearest;
                }

                ShapePoint point = shape.At(nearest - gone);
                if (point.Distance > cast.Radius + (cast.Distance / 20))
                {
                    continue;
                }

                if (isKnown)
                {
                    collider.MoveTo(gone, Quaterniond.Identity, velocity, Vector3d.Zero);
                }
                else
                {
                    collider.TouchAt(nearest - (point.Distance * point.Normal), point.Normal, velocity, shape is SphereShape sphere ? 1 / sphere.Radius : 0);
                }

                hits.Add(collider);
            }
        }
    }
}
