using System.Numerics;
using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>Plays a team, as people with gamepads would. Its decisions may differ from machine to machine, because only its inputs count.</summary>
public sealed class Brain(int team, int seed)
{
    private const int ThinksEvery = 8;
    private readonly Random _random = new(seed);
    private readonly byte[] _moves = [.. TeamInput.Stand.Moves];
    private long _rests;

    /// <summary>Returns the inputs of the team in a tick, from the match on this machine.</summary>
    public TeamInput Decide(Match match, long tick)
    {
        BallState ball = match.Runner.State;
        Player[] players = match.PlayersAt(tick);
        int first = team * Match.TeamSize;

        // The keepers move by themselves, and kick if the ball is near.
        int nearest = Enumerable.Range(first + 1, Match.TeamSize - 1).MinBy(i => (players[i].Place - ball.Position).LengthSquared);

        // The team moves up while it has the ball.
        int other = Enumerable.Range(Match.TeamSize - first, Match.TeamSize).MinBy(i => (players[i].Place - ball.Position).LengthSquared);
        bool attacks = (players[nearest].Place - ball.Position).LengthSquared < (players[other].Place - ball.Position).LengthSquared;
        Vector3d up = attacks ? new Vector3d(0, 0, team == 0 ? -20 : 20) : Vector3d.Zero;
        for (int i = (int)(tick % ThinksEvery); i < Match.TeamSize; i += ThinksEvery)
        {
            bool chases = first + i == nearest;
            Vector3d target = chases ? ball.Position + (0.3 * ball.Velocity) : Match.Home(first + i) + (0.4 * ball.Position.Horizontal) + up;
            Vector3d way = (target - players[first + i].Place).Horizontal;
            _moves[i] = Match.Move(way, chases ? 3 : way.Length > 8 ? 2 : way.Length > 2 ? 1 : 0);
        }

        KickInput? kick = null;
        int kicker = match.CanKick(first, in ball, tick) ? first : nearest;
        bool isOut = Math.Abs(ball.Position.X) > Match.HalfWidth || Math.Abs(ball.Position.Z) > Match.HalfLength;
        if (tick >= _rests && !isOut && match.CanKick(kicker, in ball, tick))
        {
            _rests = tick + 30;
            kick = Kick(match, tick, kicker, ball.Position);
        }

        return new TeamInput([.. _moves], kick);
    }

    /// <summary>Returns a shot if the goal is near, otherwise a pass. The numbers are single-precision, so that 24 bytes hold them exactly.</summary>
    private KickInput Kick(Match match, long tick, int player, Vector3d from)
    {
        var goal = new Vector3d(0, 0, team == 0 ? -52.5 : 52.5);
        bool shoots = (goal - from).Length < 45;
        int mate = (team * Match.TeamSize) + Math.Max(_random.Next(5, Match.TeamSize), _random.Next(5, Match.TeamSize));
        Vector3d way = (shoots ? goal + new Vector3d((6 * _random.NextDouble()) - 3, 0, 0) : match.PlayersAt(tick)[mate].Place) - from;
        double speed = shoots ? 24 + (8 * _random.NextDouble()) : Math.Clamp(way.Length, 8, 24);
        Vector3 velocity = ((speed * way.Horizontal.Normalized()) + new Vector3d(0, shoots ? 2 + (3 * _random.NextDouble()) : 0.25 * speed * _random.NextDouble(), 0)).ToVector3();
        var spin = new Vector3(0, (float)(40 * (_random.NextDouble() - 0.5)), 0);
        return new KickInput(tick, velocity, spin, player);
    }
}
