namespace Football.Physics;

/// <summary>A piece of smooth motion.</summary>
internal readonly struct Piece
{
    public readonly double Time;
    public readonly double Length;
    public readonly Vector3d StartPosition;
    public readonly Vector3d StartVelocity;
    public readonly Vector3d StartAcceleration;
    public readonly Vector3d EndPosition;
    public readonly Vector3d EndVelocity;

    public Piece(
        double time, double length, in Vector3d startPosition, in Vector3d startVelocity, in Vector3d startAcceleration, in Vector3d endPosition, in Vector3d endVelocity)
    {
        Time = time;
        Length = length;
        StartPosition = startPosition;
        StartVelocity = startVelocity;
        StartAcceleration = startAcceleration;
        EndPosition = endPosition;
        EndVelocity = endVelocity;
    }

    /// <summary>The greatest height over the piece, on its cubic Hermite interpolant.</summary>
    public double Apex
    {
        get
        {
            double end = Math.Max(StartPosition.Y, EndPosition.Y);
            if (!(StartVelocity.Y > 0 && EndVelocity.Y < 0))
            {
                return end;
            }

            // The lowest point of the arc turned upside down.
            var arc = new HeightArc(-StartPosition.Y, -StartVelocity.Y, 0, -EndPosition.Y, -EndVelocity.Y, Length);
            arc.Hermite(out double c1, out double c2, out double c3);
            double s = HeightArc.LowestPoint(c1, c2, c3);
            return Math.Max(end, StartPosition.Y - (s * (c1 + (s * (c2 + (s * c3))))));
        }
    }
}
