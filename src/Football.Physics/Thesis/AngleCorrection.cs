namespace Football.Physics;

/// <summary>The thesis' correction of a kick (4.1): its velocity is turned as the way to where the ball went must be turned to lead to the target.</summary>
internal static class AngleCorrection
{
    /// <summary>Turns a direction about u_guess × u_target by the angle between them.</summary>
    /// <param name="guess">From the ball to where it went.</param>
    /// <param name="target">From the ball to where it is to go.</param>
    /// <param name="direction">The direction of the kick.</param>
    /// <returns>False where there is nothing to turn by, or no axis to turn about.</returns>
    public static bool Turn(in Vector3d guess, in Vector3d target, ref Vector3d direction)
    {
        Vector3d normal = Vector3d.Cross(in guess, in target);
        double sine = normal.Length;
        if (!(sine > 0))
        {
            return false;
        }

        double angle = Elementary.Atan2(sine, Vector3d.Dot(in guess, in target));
        direction = Quaterniond.FromAxisAngle(normal / sine, angle).Rotate(in direction);
        return true;
    }
}
