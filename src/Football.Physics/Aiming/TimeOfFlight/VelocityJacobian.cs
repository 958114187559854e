namespace Football.Physics;

/// <summary>How the place of a ball at a given time moves with the velocity of its kick, s.</summary>
internal struct VelocityJacobian
{
    private Vector3d _byX;
    private Vector3d _byY;
    private Vector3d _byZ;

    public VelocityJacobian(in Vector3d byX, in Vector3d byY, in Vector3d byZ)
    {
        _byX = byX;
        _byY = byY;
        _byZ = byZ;
    }

    /// <summary>One that stretches differently along a direction and across it.</summary>
    /// <param name="direction">Unit vector.</param>
    /// <param name="along">Along it, s.</param>
    /// <param name="across">Across it, s.</param>
    public static VelocityJacobian Along(in Vector3d direction, double along, double across)
    {
        // J = a I + (b − a) û ûᵀ
        Vector3d more = (along - across) * direction;
        return new VelocityJacobian(
            (direction.X * more) + new Vector3d(across, 0, 0),
            (direction.Y * more) + new Vector3d(0, across, 0),
            (direction.Z * more) + new Vector3d(0, 0, across));
    }

    /// <summary>The same without influence of, or on, the vertical: for a ball on the ground.</summary>
    public readonly VelocityJacobian Horizontal(double vertical) => new(_byX.Horizontal, new Vector3d(0, vertical, 0), _byZ.Horizontal);

    /// <summary>The change of velocity that moves the ball: J Δv = Δp.</summary>
    /// <returns>False where the Jacobian is singular.</returns>
    public readonly bool Solve(in Vector3d move, out Vector3d change)
    {
        // Cramer's rule
        Vector3d yz = Vector3d.Cross(in _byY, in _byZ);
        double determinant = Vector3d.Dot(in _byX, in yz);
        change = new Vector3d(
            Vector3d.Dot(in move, in yz),
            Vector3d.Dot(in _byX, Vector3d.Cross(in move, in _byZ)),
            Vector3d.Dot(in _byX, Vector3d.Cross(in _byY, in move))) / determinant;
        return change.IsFinite;
    }

    /// <summary>How the place moves with a change of the velocity: J Δv, m.</summary>
    public readonly Vector3d Product(in Vector3d change) => (change.X * _byX) + (change.Y * _byY) + (change.Z * _byZ);

    /// <summary>Broyden's update after a change of the velocity moved the ball: J += (Δp − J Δv) Δvᵀ / |Δv|².</summary>
    public void Update(in Vector3d change, in Vector3d move)
    {
        double squared = change.LengthSquared;
        if (!(squared > 0))
        {
            return;
        }

        Vector3d error = (move - Product(in change)) / squared;
        _byX += change.X * error;
        _byY += change.Y * error;
        _byZ += change.Z * error;
    }
}
