namespace Football.Physics;

/// <summary>
/// Whether a target can be reached at a speed: the greatest height above it, over all elevations within the bounds, at which a ball passes its
/// distance. That grows with the speed, and is zero for the slowest kick that hits.
/// </summary>
internal sealed class ReachBound
{
    /// <summary>The top of the heights is known when the elevation moves by less, rad: what that hides is below a tenth of a millimetre.</summary>
    private const double TopAngle = 5e-4;

    private readonly PlaneProblem _problem;
    private readonly PlaneShot[] _shots = new PlaneShot[24];
    private Kick _kick;

    public ReachBound(PlaneProblem problem) => _problem = problem;

    /// <summary>The greatest height, m; not a number for a target straight above or below.</summary>
    public double Of(AimRequest request, double speed)
    {
        _problem.Set(request, speed, request.TopSpin, request.SideSpin);
        if (_problem.Frame.Distance < 1e-6)
        {
            return double.NaN;
        }

        _problem.Guess(out _kick);
        PlaneShot low = Aligned(Fly(_problem.Bounds.Lowest));
        PlaneShot high = Aligned(Fly(_problem.Bounds.Highest));
        return Highest(in low, in high).Up;
    }

    /// <summary>The elevation with the greatest height at the target's distance: successive parabolas through the best shot and its neighbours.</summary>
    private PlaneShot Highest(in PlaneShot low, in PlaneShot high)
    {
        _shots[0] = low;
        _shots[1] = high;
        int count = 2;
        int best = low.Up >= high.Up ? 0 : 1;
        while (count < _shots.Length)
        {
            PlaneShot at = _shots[best];
            double next = best == 0 ? 0.5 * (at.Kick.Elevation + _shots[1].Kick.Elevation)
                : best == count - 1 ? 0.5 * (at.Kick.Elevation + _shots[best - 1].Kick.Elevation)
                : Vertex(in _shots[best - 1], in at, in _shots[best + 1]);

            // A parabola that no longer moves has found the top: what is left is of second order in its last move.
            if (Math.Abs(next - at.Kick.Elevation) < TopAngle)
            {
                break;
            }

            Align(at.Crossed ? at : _shots[count - 1]);
            PlaneShot shot = Fly(next);
            int place = count;
            while (_shots[place - 1].Kick.Elevation > next)
            {
                _shots[place] = _shots[place - 1];
                place--;
            }

            _shots[place] = shot;
            count++;
            best = shot.Up > at.Up ? place : place <= best ? best + 1 : best;
        }

        return _shots[best];
    }

    /// <summary>The vertex of the parabola through three shots, kept off the outer ones.</summary>
    private static double Vertex(in PlaneShot a, in PlaneShot b, in PlaneShot c)
    {
        double left = b.Kick.Elevation - a.Kick.Elevation;
        double right = c.Kick.Elevation - b.Kick.Elevation;
        if (!a.Crossed || !c.Crossed)
        {
            // A shot that fell short has no true height: halve towards it.
            return !a.Crossed && (c.Crossed || left > right) ? b.Kick.Elevation - (0.5 * left) : b.Kick.Elevation + (0.5 * right);
        }

        // Neighbours of very different distance make bad parabolas: then the larger gap is halved first.
        if (Math.Max(left, right) > 8 * Math.Min(left, right) && Math.Max(left, right) > 0.05)
        {
            return left > right ? b.Kick.Elevation - (0.3 * left) : b.Kick.Elevation + (0.3 * right);
        }

        double riseLeft = b.Up - a.Up;
        double riseRight = b.Up - c.Up;
        double below = (left * riseRight) + (right * riseLeft);
        double move = below > 0 ? 0.5 * ((right * right * riseLeft) - (left * left * riseRight)) / below : 0;
        return b.Kick.Elevation + Math.Min(Math.Max(move, -0.9 * left), 0.9 * right);
    }

    private PlaneShot Fly(double elevation)
    {
        _kick.Elevation = elevation;
        return _problem.Fly(in _kick);
    }

    /// <summary>Flies once more with the azimuth that the last flight asks for, where it was far off.</summary>
    private PlaneShot Aligned(in PlaneShot shot)
    {
        Align(in shot);
        return shot.Crossed && Math.Abs(shot.Left) > 0.02 * _problem.Frame.Distance ? Fly(shot.Kick.Elevation) : shot;
    }

    /// <summary>Turns the next kick by the angle by which a flight passed the target.</summary>
    private void Align(in PlaneShot shot)
    {
        _kick = shot.Kick;
        if (shot.Crossed)
        {
            // The whole flight turns with the azimuth; its crossing moves along the plane by that much and a little more.
            ref readonly TargetFrame frame = ref _problem.Frame;
            double slope = Vector3d.Dot(in shot.Velocity, in frame.Left) / Math.Max(Vector3d.Dot(in shot.Velocity, in frame.Forward), 1e-3);
            _kick.Azimuth += Elementary.Atan2(-shot.Left, Math.Max(0.2 * frame.Distance, frame.Distance + (slope * shot.Left)));
        }
    }
}
