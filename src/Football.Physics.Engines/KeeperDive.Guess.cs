namespace FootballPhysics.Engines;

/// <content>A dive to which he commits before the kick.</content>
public sealed partial class KeeperDive
{
    /// <summary>The abilities of a keeper at a penalty, against whom shooters score about three of four if he also guesses a side.</summary>
    /// <remarks>
    /// Reaction 0.245 s: the time after a penalty kick at which the vertical part of a keeper's dive begins (measured; Higueras-Herbada et al., Front. Psychol. 11:311, 2020).
    /// Acceleration, speed, reach and height are chosen so that with <see cref="KeeperGuess.Draw"/> the shares of <c>lab penalties</c> agree with published ones: of 2 379 penalties
    /// at World Cups, European Championships and in European cups, 77.8 % were scored (Brinkschulte, Furley and Memmert, doi:10.21203/rs.3.rs-400697/v1, 2021).
    /// </remarks>
    public static Player Penalty => new() { Reaction = 0.245, Acceleration = 8, Speed = 4.5, Reach = 0.3, MaximumHeight = 2.4 };

    /// <summary>True while he is in the dive of his guess.</summary>
    private bool IsCommitted => Guess is { } guess && _last.Dive.Start == guess.Time && _now < _last.Dive.End;

    /// <summary>Starts the dive of a guess.</summary>
    private void Commit(in KeeperGuess guess, in BallState ball)
    {
        KeeperState present = At(guess.Time);
        Vector3d feet = Feet(present.Pose);
        if (SideOf(guess.Target) == 0)
        {
            return;
        }

        // The dive takes the time that his hands need.
        double duration = TimeFor((guess.Target - feet).Horizontal.Length - _abilities.Reach);
        BallPose to = Reaching(in feet, guess.Target, duration);
        _last.Seen = ball;
        _last.Target = guess.Target;
        _last.Before = Motion(ref _last, guess.Time);
        _last.Dive = KeeperMotion.Within(in present, in to, guess.Time, guess.Time + duration, _abilities.Speed);
        _last.Count++;
        Remember();
    }

    /// <summary>Adapts the dive to a ball on its side of the goal.</summary>
    private void Adapt(in BallState ball)
    {
        Vector3d feet = Feet(At(_now).Pose);
        Player self = Standing(in feet).Reacting(0);
        KeeperResult answer = _interception.FindSave(_path.Path, in self, Goal, _now);
        PathPoint at = Meeting(in answer, in self, _now);
        if (!answer.Crosses || !answer.IsOnTarget || SideOf(at.Position) != SideOf(_last.Target))
        {
            return;
        }

        // A rollback to this decision computes the path from this ball, so compute it from there now too.
        _path.Invalidate();
        _path.Update(in ball);
        _last.Seen = ball;
        _last.Answer = answer;
        _last.Target = at.Position;

        // He is in his dive since the guess, so he gets as far as from there.
        BallPose to = Reaching(Feet(_last.Dive.From.Pose), at.Position, at.Time - _last.Dive.Start);
        _last.Before = _last.Dive;
        _last.Dive = KeeperMotion.Within(At(_now), in to, _now, at.Time, _abilities.Speed);
        Remember();
    }

    /// <summary>Returns the side of a position as he sees it: 1 right, −1 left, 0 where he can stand.</summary>
    private int SideOf(in Vector3d position)
    {
        double aside = Vector3d.Dot(position - _feet, Goal.Right);
        return Math.Abs(aside) <= StandsUpTo ? 0 : Math.Sign(aside);
    }

    /// <summary>Returns the distance that he runs in a time: D(s) = ½ a s² while s ≤ v/a, then v (s − v/2a).</summary>
    private double RunIn(double time)
    {
        double speeding = _abilities.Speed / _abilities.Acceleration;
        return time <= speeding ? 0.5 * _abilities.Acceleration * time * time : _abilities.Speed * (time - (0.5 * speeding));
    }

    /// <summary>Returns the time in which he runs a distance, in s.</summary>
    private double TimeFor(double distance)
    {
        double speeding = _abilities.Speed / _abilities.Acceleration;
        double whileSpeeding = 0.5 * _abilities.Speed * speeding;
        return distance <= 0 ? 0 : distance <= whileSpeeding ? Math.Sqrt(2.0 * distance / _abilities.Acceleration) : (distance / _abilities.Speed) + (0.5 * speeding);
    }
}
