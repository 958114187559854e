namespace Football.Physics;

/// <summary>A ball at rest among things that move: it waits until one of them hits it.</summary>
internal sealed class RestPhase
{
    private readonly World _world;
    private readonly WorldGuard _guard;

    public RestPhase(World world, WorldGuard guard)
    {
        _world = world;
        _guard = guard;
    }

    /// <summary>Up to the end of the step, or to the hit.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        if (_guard.HitsAtOnce(ref s, ref run))
        {
            return;
        }

        // It moves along with what carries it, straight on, up to the first thing that comes its way.
        double h = run.Left;
        Vector3d velocity = _world.HangsInNet(in s) ? Vector3d.Zero : _world.CarrierOf(in s).Velocity;
        var path = PathCubic.Line(s.Position, in velocity, h);
        double at = new ContactSearch(_world, in path, s.Time).First(in s, (int)s.Carrier - _world.FirstCollider, out Separation met);
        bool meets = at <= h;
        h = meets ? at : h;
        s.Position = path.At(h);
        run.Advance(ref s, h);

        // Waiting is no integrated piece.
        run.Log.Steps--;
        if (meets)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }
}
