namespace FootballPhysics.Labs;

/// <summary>A method with a step: its errors, m, and its work a second of motion.</summary>
internal sealed record PrecisionRow(
    Integrator Method, double Step, bool Thesis, double Mean, double P95, double Worst, double Evaluations, double Nanoseconds);

/// <summary>Where and when a shot ended.</summary>
internal readonly record struct PrecisionPoint(Vector3d Place, double Time);
