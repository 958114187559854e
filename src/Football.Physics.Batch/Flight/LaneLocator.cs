using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Locates the end and the highest point of a ball within its last step in lanes, in double precision.</summary>
internal static class LaneLocator
{
    /// <summary>Ends a flight where its cubic Hermite interpolant reaches the limit.</summary>
    [MethodImpl(Hot.Path)]
    public static void Reach(LaneGroup group, int at, double time, double length)
    {
        double limit = group.Limit[at];
        var piece = new LanePiece(group, at, time, length);
        if (group.CrossingOf(at) is >= 0 and int crossing)
        {
            var first = new LanePiece(group, at, crossing, first: true, time, length);
            piece = first.EndHeight < limit ? first : new LanePiece(group, at, crossing, first: false, time, length);
        }

        double start = piece.StartHeight - limit;
        double end = piece.EndHeight - limit;
        end = end < 0 ? end : 0;
        var height = new CubicHermite(start > 0 ? start : 0, piece.StartRise * piece.Length, end, piece.EndRise * piece.Length);
        double tau = HeightArc.Root(in height, end) * piece.Length;
        piece.At(tau, out Vector3d path, out Vector3d velocity, out double spin);
        group.End(at, piece.Start + tau, reached: true, in path, in velocity, spin);
    }

    /// <summary>Stores the highest point of the last step.</summary>
    [MethodImpl(Hot.Path)]
    public static void Top(LaneGroup group, int at, double time, double length)
    {
        var piece = new LanePiece(group, at, time, length);
        if (group.CrossingOf(at) is >= 0 and int crossing)
        {
            var first = new LanePiece(group, at, crossing, first: true, time, length);
            piece = first.EndRise < 0 ? first : new LanePiece(group, at, crossing, first: false, time, length);
        }

        var height = new CubicHermite(piece.StartHeight, piece.StartRise * piece.Length, piece.EndHeight, piece.EndRise * piece.Length);
        double top = height.At(height.Highest);
        int ball = group.Ball[at];
        group.Apex[ball] = top > group.Apex[ball] ? top : group.Apex[ball];
    }
}
