namespace Football.Physics;

/// <summary>A stage of a step: where a method asked for the rates, what they were, and how they change with the motion.</summary>
internal sealed class StageJacobian
{
    /// <summary>A = ∂ẏ/∂y.</summary>
    public readonly double[] Jacobian = new double[MotionVector.Size * MotionVector.Size];

    /// <summary>v of the stage.</summary>
    public Vector3d Velocity;

    /// <summary>v̇, ω̇ of the stage.</summary>
    public MotionRates Rates;

    /// <summary>A δy, but the change of the place, which is the velocity's.</summary>
    public MotionRates Times(in Motion at) => new(Rows(MotionVector.Velocity, in at), Rows(MotionVector.Spin, in at), Row(MotionVector.AirDistance, in at));

    private Vector3d Rows(int row, in Motion at) => new(Row(row, in at), Row(row + 1, in at), Row(row + 2, in at));

    private double Row(int row, in Motion at)
    {
        double[] a = Jacobian;
        int i = row * MotionVector.Size;
        return (a[i] * at.Position.X) + (a[i + 1] * at.Position.Y) + (a[i + 2] * at.Position.Z)
            + (a[i + 3] * at.Velocity.X) + (a[i + 4] * at.Velocity.Y) + (a[i + 5] * at.Velocity.Z)
            + (a[i + 6] * at.Spin.X) + (a[i + 7] * at.Spin.Y) + (a[i + 8] * at.Spin.Z) + (a[i + 9] * at.AirDistance);
    }
}
