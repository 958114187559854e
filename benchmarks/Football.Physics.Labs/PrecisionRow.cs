namespace FootballPhysics.Labs;

/// <summary>A method with a step: its errors, m, and its work per second of motion.</summary>
internal sealed record PrecisionRow(
    Integrator Method, double Step, bool Thesis, double Mean, double P95, double Worst, double Evaluations, double Nanoseconds);

/// <summary>The position and time of the end of a shot.</summary>
internal readonly record struct PrecisionPoint(Vector3d Place, double Time);
