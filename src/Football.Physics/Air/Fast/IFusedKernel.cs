namespace Football.Physics;

/// <summary>The laws of a model fused into one evaluation, which holds in a part of their domain.</summary>
internal interface IFusedKernel<TStep> : IFlightKernel<TStep>
    where TStep : struct
{
    /// <summary>Reads the constants of all laws from the scene.</summary>
    void Prepare(Scene scene);

    /// <inheritdoc cref="IAir.Covers"/>
    bool Covers(double speedSquared, double spinRate, double h);
}
